#pragma once

#include <algorithm>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// A format's name ("NIfTI") and the endings of its files, in lower case and with their dots.
struct FileFormat
{
  std::string Name;
  std::vector<std::string> ReadEndings;    ///< empty for a write-only format
  std::vector<std::string> WrittenEndings; ///< empty for a read-only format
};

/// The longest of the endings that matches the file name, ignoring case; empty if none does.
std::string EndingOf(const std::filesystem::path& file, const std::vector<std::string>& endings);
/// Endings for a message: ".vtp, .stl or .ply".
std::string ListOfEndings(const std::vector<std::string>& endings);
/// Endings for a file dialog: "*.vtp *.stl *.ply".
std::string PatternsOf(const std::vector<std::string>& endings);

/// The formats of one kind of file, each declared once; readers, writers, dialogs and lists use
/// this list. Not thread-safe: add formats before files are read.
template <typename Format>
class FormatList
{
public:
  explicit FormatList(std::vector<Format> formats) : Formats(std::move(formats)) {}

  void Add(Format format) { this->Formats.push_back(std::move(format)); }

  /// Null if no format reads, or writes, files of this ending.
  const Format* Reader(const std::filesystem::path& file) const
  {
    return this->Find(file, &FileFormat::ReadEndings);
  }
  const Format* Writer(const std::filesystem::path& file) const
  {
    return this->Find(file, &FileFormat::WrittenEndings);
  }

  std::vector<std::string> ReadEndings() const { return this->All(&FileFormat::ReadEndings); }
  std::vector<std::string> WrittenEndings() const { return this->All(&FileFormat::WrittenEndings); }

  auto begin() const { return this->Formats.begin(); }
  auto end() const { return this->Formats.end(); }

private:
  using Endings = std::vector<std::string> FileFormat::*;

  const Format* Find(const std::filesystem::path& file, Endings endings) const
  {
    const Format* found = nullptr;
    std::size_t length = 0;
    for (const Format& format : this->Formats)
    {
      const std::string ending = EndingOf(file, format.*endings);
      found = ending.size() > length ? &format : found;
      length = std::max(length, ending.size());
    }
    return found;
  }

  std::vector<std::string> All(Endings endings) const
  {
    std::vector<std::string> all;
    for (const Format& format : this->Formats)
    {
      all.insert(all.end(), (format.*endings).begin(), (format.*endings).end());
    }
    return all;
  }

  std::vector<Format> Formats;
};
} // namespace palpate
