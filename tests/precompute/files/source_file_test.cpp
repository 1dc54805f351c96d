// Models on the disk: nothing outside a model's own folder is ever opened.
#include "precompute/files/source_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/precompute/commands/command_run.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::string& path) {
  const auto bytes = readModelFile(path);
  EXPECT_FALSE(bytes) << path << " was read";
  return bytes ? "" : bytes.error().message;
}

TEST(SourceFile, OnlyPlainFilesOfAnAcceptedSizeAreRead) {
  const TemporaryFolder folder;
  writeTextFile(folder / "room.glb", "abc");
  const auto bytes = readModelFile(folder / "room.glb");
  ASSERT_TRUE(bytes) << bytes.error().message;
  EXPECT_EQ(*bytes, (std::vector<std::uint8_t>{'a', 'b', 'c'}));

  EXPECT_THAT(refusal("/dev/zero"), HasSubstr("is not a file"));
  EXPECT_THAT(refusal(folder.path()), HasSubstr("is not a file"));
  EXPECT_THAT(refusal("/nowhere/at/all.glb"), HasSubstr("does not exist"));
  std::filesystem::resize_file(folder / "room.glb",
                               (std::uintmax_t{256} << 20) + 1);  // sparse: it takes no disk
  EXPECT_THAT(refusal(folder / "room.glb"), HasSubstr("256 MB"));
}

TEST(SourceFile, SiblingsAreThoseOfTheFolder) {
  const TemporaryFolder folder;
  std::filesystem::create_directories(folder / "inner/below");
  writeTextFile(folder / "secret.bin", "abcd");
  writeTextFile(folder / "inner/room.bin", "ab");
  writeTextFile(folder / "inner/below/room.bin", "a");
  const Resolve resolve = siblingsOf(folder / "inner/room.gltf");
  for (const auto& [name, size] : {std::pair{"room.bin", 2u}, {"below/room.bin", 1u}}) {
    const auto found = resolve(name);
    ASSERT_TRUE(found && *found) << name;
    EXPECT_EQ((*found)->size(), size);
  }
  const auto missing = resolve("nowhere.bin");
  ASSERT_TRUE(missing);
  EXPECT_FALSE(*missing);

  // Links may lead to a place within, not to one outside; nor may a name, were it ever asked for.
  std::filesystem::create_symlink(folder / "secret.bin", folder / "inner/link.bin");
  std::filesystem::create_symlink(folder.path(), folder / "inner/up");
  std::filesystem::create_symlink(folder / "inner/below/room.bin", folder / "inner/within.bin");
  for (const char* name : {"link.bin", "up/secret.bin", "../secret.bin"}) {
    const auto refused = resolve(name);
    ASSERT_FALSE(refused) << name;
    EXPECT_THAT(refused.error().message, HasSubstr("links to outside the file's folder"));
  }
  EXPECT_TRUE(resolve("within.bin"));
  EXPECT_FALSE(resolve("below"));
}

TEST(SourceFile, AModelInTheWorkingFolderHasSiblingsThere) {
  const auto missing = siblingsOf("room.gltf")("nowhere.bin");
  ASSERT_TRUE(missing);
  EXPECT_FALSE(*missing);
}

}  // namespace
}  // namespace fiatlux
