# One static library a folder, named after it (core/scene -> core_scene). USES names the folders that its sources may
# include, LINKS the libraries of others. The direction is held twice: each library must link with what it uses and
# nothing else (the *_stands targets of the native build), and tests/scripts/directions.test.mjs reads the same lines and follows
# every include. Sources of a folder are compiled as one (FIATLUX_TOGETHER), for most of a compiler's work is the headers that
# they share, so names in unnamed namespaces are each folder's own once. The sanitize build compiles each on its own, so that
# none leans on another's includes.
function(fiatlux_library folder)
  cmake_parse_arguments(ARG "" "" "USES;LINKS" ${ARGN})
  string(REPLACE "/" "_" name ${folder})
  list(TRANSFORM ARG_USES REPLACE "/" "_" OUTPUT_VARIABLE uses)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/*.cpp)
  if(NOT sources)  # headers alone
    add_library(${name} INTERFACE)
    target_include_directories(${name} INTERFACE ${CMAKE_SOURCE_DIR})
    target_link_libraries(${name} INTERFACE ${uses} ${ARG_LINKS})
    return()
  endif()
  add_library(${name} STATIC ${sources})
  target_include_directories(${name} PUBLIC ${CMAKE_SOURCE_DIR})
  target_link_libraries(${name} PUBLIC ${uses} PRIVATE ${ARG_LINKS})
  if(FIATLUX_TOGETHER)
    set_target_properties(${name} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 0)
  endif()
  if(FIATLUX_TESTS AND NOT EMSCRIPTEN AND NOT FIATLUX_SANITIZE)
    add_executable(${name}_stands ${CMAKE_SOURCE_DIR}/cmake/stands.cpp)
    target_link_libraries(${name}_stands PRIVATE
      -Wl,--whole-archive $<TARGET_FILE:${name}> -Wl,--no-whole-archive ${uses} ${ARG_LINKS})
    add_dependencies(${name}_stands ${name})
  endif()
endfunction()
