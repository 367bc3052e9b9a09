#include "EarlierFiles.h"
#include "InputError.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>

namespace palpate::earlier_files_test
{
namespace
{
using palpate::test::TemporaryFolder;
using palpate::test::WriteAll;

const std::vector<std::string> Names{"report.html", "model.json", "surface.vtp"};

// The file that is refused; empty if all may be replaced.
std::string Refused(const TemporaryFolder& folder)
{
  try
  {
    RequireEarlierFiles(folder.Path(), Names);
    return {};
  }
  catch (const InputError& error)
  {
    const std::string message = error.what();
    return std::filesystem::path(message.substr(0, message.find(" would"))).filename().string();
  }
}

std::string OwnPage()
{
  return std::string("<!DOCTYPE html>\n<head>\n") + PageGenerator + "\n</head>";
}

TEST(EarlierFiles, PagesAreRecognisedByTheirHeadOrByTheStyleOfOlderOnes)
{
  const TemporaryFolder folder;
  EXPECT_EQ(Refused(folder), "");
  WriteAll(folder / "report.html", "<!DOCTYPE html>\n<p>written with palpate-viewer</p>");
  EXPECT_EQ(Refused(folder), "report.html");
  WriteAll(folder / "report.html", OwnPage());
  EXPECT_EQ(Refused(folder), "");
  WriteAll(folder / "report.html",
           "<!DOCTYPE html>\n<style>\n:root {\n  color-scheme: light dark;\n"
           "  --paper: #ffffff; --panel: #f6f7f9; --ink: #1c2127; --soft: #5c6670;");
  EXPECT_EQ(Refused(folder), "");
  WriteAll(folder / "report.html", "");
  EXPECT_EQ(Refused(folder), "") << "nothing is lost";
  WriteAll(folder / "other.html", "<p>findings</p>");
  std::filesystem::remove(folder / "report.html");
  std::filesystem::create_symlink("other.html", folder / "report.html");
  EXPECT_EQ(Refused(folder), "") << "the link alone is replaced";
}

TEST(EarlierFiles, ForeignPageIsKeptEvenBesideOwnFiles)
{
  const TemporaryFolder folder;
  WriteAll(folder / "report.html", "<p>findings</p>");
  WriteAll(folder / "model.json", R"({ "format": "palpate spherical-harmonic model" })");
  EXPECT_EQ(Refused(folder), "report.html");
}

TEST(EarlierFiles, JsonIsReplacedOnlyBesideOwnFiles)
{
  const TemporaryFolder folder;
  WriteAll(folder / "model.json", R"({ "layers": [] })");
  EXPECT_EQ(Refused(folder), "model.json");
  WriteAll(folder / "report.html", OwnPage());
  EXPECT_EQ(Refused(folder), "");
}

// A page that was lost does not keep the rest from being written again.
TEST(EarlierFiles, MeshesAreReplaced)
{
  const TemporaryFolder folder;
  WriteAll(folder / "surface.vtp", "<VTKFile>");
  EXPECT_EQ(Refused(folder), "");
}

TEST(EarlierFiles, SameFileIsFoundThroughLinks)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a", "a");
  WriteAll(folder / "b", "a");
  std::filesystem::create_symlink("a", folder / "link");
  EXPECT_THROW(RequireOtherFile(folder / "a", folder.Path() / "." / "a"), InputError);
  EXPECT_THROW(RequireOtherFile(folder / "link", folder / "a"), InputError);
  EXPECT_THROW(RequireOtherFile(folder / "a", folder / "link"), InputError);
  EXPECT_NO_THROW(RequireOtherFile(folder / "b", folder / "a"));
  EXPECT_NO_THROW(RequireOtherFile(folder / "new", folder / "a"));
  EXPECT_NO_THROW(RequireOtherFile(folder.Path(), folder.Path()));
}
} // namespace
} // namespace palpate::earlier_files_test
