#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace palpate::cli
{
/// Declares that the value of an option names a file: option->check(FileType::Output("geometry")).
/// Contents are those of 3D Slicer's descriptions: file, directory, image, label (a segmentation as
/// an image), geometry, table. It checks nothing, since the readers do, and does not change --help.
class FileType : public CLI::Validator
{
public:
  /// What was declared.
  struct Declared
  {
    std::string Content;
    bool IsOutput;
    std::string Ending;             ///< of the files, such as .png; empty for any
    std::vector<std::string> Names; ///< that are written into an output folder, as far as known
  };

  static FileType Input(const std::string& content, const std::string& ending = {});
  static FileType Output(const std::string& content, const std::string& ending = {});
  /// A folder, into which files of these names are written.
  static FileType OutputFolder(const std::vector<std::string>& names);
  /// Nothing if the option names no file.
  static std::optional<Declared> Of(const CLI::Option& option);

private:
  explicit FileType(const std::string& name) : CLI::Validator("") { this->name(name); }
};
} // namespace palpate::cli
