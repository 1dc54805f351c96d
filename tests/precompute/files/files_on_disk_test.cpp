// Files whole or not at all, and what is said where they cannot be.
#include "precompute/files/files_on_disk.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/precompute/commands/command_run.h"

namespace fiatlux {
namespace {

using ::testing::HasSubstr;

template <class T>
std::string errorOf(const Result<T>& result) {
  return result ? "no error" : result.error().message;
}

TEST(FilesOnDisk, AFileIsReplacedWhole) {
  const TemporaryFolder folder;
  ASSERT_TRUE(replaceFile(folder / "a", "first, and longer"));
  ASSERT_TRUE(replaceFile(folder / "a", "second"));
  EXPECT_EQ(textOfFile(folder / "a"), "second");
  EXPECT_EQ(folder.files(), 1u);
  const auto bytes = readFileBytes(folder / "a");
  ASSERT_TRUE(bytes);
  EXPECT_EQ(std::string(bytes->begin(), bytes->end()), "second");
}

TEST(FilesOnDisk, ALinkStaysALink) {
  const TemporaryFolder folder;
  writeTextFile(folder / "a", "old");
  std::filesystem::create_symlink("a", folder / "link");
  ASSERT_TRUE(replaceFile(folder / "link", "new"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link"));
  EXPECT_EQ(textOfFile(folder / "a"), "new");
}

TEST(FilesOnDisk, WhatCannotBeWrittenIsSaidBeforeAndAfter) {
  const TemporaryFolder folder;
  const std::string nowhere = folder / "none/a", tooLong = folder / std::string(300, 'x');
  for (const Result<Done>& result : {checkReplaceable(nowhere), replaceFile(nowhere, "x")})
    EXPECT_EQ(errorOf(result), nowhere + ": cannot be written: there is no such folder");
  for (const Result<Done>& result : {checkReplaceable(folder.path()), replaceFile(folder.path(), "x")})
    EXPECT_EQ(errorOf(result), folder.path() + ": cannot be written: that is a folder");
  for (const Result<Done>& result : {checkReplaceable(tooLong), replaceFile(tooLong, "x")})
    EXPECT_THAT(errorOf(result), HasSubstr("name"));
  EXPECT_FALSE(replaceFile(folder / std::string(5000, 'x'), "x"));
  EXPECT_THAT(errorOf(replaceFile("/dev/full", "x")), HasSubstr("the disk is full"));
  EXPECT_EQ(folder.files(), 0u);
}

TEST(FilesOnDisk, CheckingLeavesNothing) {
  const TemporaryFolder folder;
  writeTextFile(folder / "a", "old");
  EXPECT_TRUE(checkReplaceable(folder / "a"));
  EXPECT_TRUE(checkReplaceable(folder / "b"));
  EXPECT_TRUE(checkReplaceable("/dev/null"));
  EXPECT_EQ(textOfFile(folder / "a"), "old");
  EXPECT_EQ(folder.files(), 1u);
}

TEST(FilesOnDisk, WhatCannotBeReadIsSaid) {
  const TemporaryFolder folder;
  writeTextFile(folder / "big", std::string((1 << 20) + 1, 'x'));
  EXPECT_EQ(errorOf(readFileBytes(folder / "none")),
            folder / "none" + ": cannot be read: there is no such file");
  EXPECT_EQ(errorOf(readFileBytes(folder.path())), folder.path() + ": cannot be read: that is a folder");
  EXPECT_EQ(errorOf(readFileBytes(folder / "big", 1 << 20)),
            folder / "big" + ": cannot be read: it is larger than 1 MB");
  EXPECT_EQ(readFileBytes(folder / "big", (1 << 20) + 1)->size(), (1u << 20) + 1);
  EXPECT_EQ(errorOf(readFileBytes("/dev/zero", 1 << 20)),
            "/dev/zero: cannot be read: it is larger than 1 MB");
}

TEST(FilesOnDisk, ErrorsOfWhatIsInAFileBeginWithItsPath) {
  const TemporaryFolder folder;
  writeTextFile(folder / "a", "text");
  const auto length = [](const std::string& text) -> Result<std::size_t> { return text.size(); };
  const auto refuse = [](const std::string& text) -> Result<std::size_t> { return Error{"no " + text}; };
  EXPECT_EQ(parsedFile(folder / "a", 10, length).value(), 4u);
  EXPECT_EQ(errorOf(parsedFile(folder / "a", 10, refuse)), folder / "a" + ": no text");
  EXPECT_THAT(errorOf(parsedFile(folder / "none", 10, length)), HasSubstr("no such file"));
}

}  // namespace
}  // namespace fiatlux
