#pragma once

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace palpate::test
{
/// An empty folder of one test, removed with its content.
class TemporaryFolder
{
public:
  TemporaryFolder()
  {
    std::string pattern = (std::filesystem::temp_directory_path() / "palpate-test-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr)
    {
      throw std::runtime_error("a temporary folder cannot be created");
    }
    this->Folder = pattern;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder()
  {
    std::error_code ignored;
    std::filesystem::remove_all(this->Folder, ignored);
  }

  const std::filesystem::path& Path() const { return this->Folder; }
  std::filesystem::path operator/(const std::string& name) const { return this->Folder / name; }
  /// Number of files and folders in it, including hidden ones.
  std::size_t EntryCount() const
  {
    const std::filesystem::directory_iterator first(this->Folder);
    return static_cast<std::size_t>(std::distance(first, std::filesystem::directory_iterator()));
  }

private:
  std::filesystem::path Folder;
};

inline std::string ReadAll(const std::filesystem::path& path)
{
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

inline void WriteAll(const std::filesystem::path& path, const std::string& bytes)
{
  std::ofstream(path, std::ios::binary) << bytes;
}
} // namespace palpate::test
