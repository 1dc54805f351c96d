# GoogleTest for Wasm: Debian's sources compiled by em++, under the names that find_package(GTest) gives natively.
# A test binary is a plain script that Node runs (CMAKE_CROSSCOMPILING_EMULATOR).
set(GOOGLETEST /usr/src/googletest)
if(NOT EXISTS ${GOOGLETEST}/googletest/src/gtest-all.cc)
  message(FATAL_ERROR "${GOOGLETEST} is missing: apt-get install libgtest-dev libgmock-dev")
endif()
add_library(gtest_wasm STATIC
  ${GOOGLETEST}/googletest/src/gtest-all.cc
  ${GOOGLETEST}/googlemock/src/gmock-all.cc
  ${GOOGLETEST}/googlemock/src/gmock_main.cc)
target_include_directories(gtest_wasm SYSTEM
  PUBLIC ${GOOGLETEST}/googletest/include ${GOOGLETEST}/googlemock/include
  PRIVATE ${GOOGLETEST}/googletest ${GOOGLETEST}/googlemock)
target_compile_definitions(gtest_wasm PUBLIC GTEST_HAS_PTHREAD=0)
target_compile_options(gtest_wasm PRIVATE -w)
add_library(GTest::gtest ALIAS gtest_wasm)
add_library(GTest::gmock ALIAS gtest_wasm)
add_library(GTest::gtest_main ALIAS gtest_wasm)

# note: compiled synchronously, because the asynchronous glue would fetch() a path, which fails in Node 18 and later.
add_link_options(-sENVIRONMENT=node -sWASM_ASYNC_COMPILATION=0 -sNODERAWFS=1 -sALLOW_MEMORY_GROWTH=1 -sMAXIMUM_MEMORY=4GB
                 -sEXIT_RUNTIME=1 -sTOTAL_STACK=1MB)
file(WRITE ${CMAKE_BINARY_DIR}/package.json "{ \"type\": \"commonjs\" }\n")
