#include "InfoCommand.h"

#include "AvailableMemory.h"
#include "Console.h"
#include "FileType.h"
#include "ImageContent.h"
#include "ImageFormat.h"
#include "InfoReport.h"
#include "InputError.h"
#include "LabelStatistics.h"
#include "MaskFolder.h"
#include "MaskFolders.h"

#include <CLI/CLI.hpp>
#include <optional>
#include <ostream>
#include <utility>

namespace palpate::cli
{
std::string InfoCommand::Examples() const
{
  return "  palpate info t2.nii.gz mask.seg.nrrd     geometry, values, labels\n"
         "  palpate info dicom-folder --series 2     the second series of a folder\n"
         "  palpate info *.nii.gz --json             one JSON object per line, for scripts";
}

void InfoCommand::DeclareOptions(CLI::App& app)
{
  app.add_option("FILE", this->Inputs,
                 "Images and segmentations (" + ListOfEndings(ReadableImageEndings()) +
                     ", or a DICOM folder, or a folder of masks)")
      ->required()
      ->check(FileType::Input("image"));
  this->Images.Declare(app, "folder");
  app.add_flag("--json", this->Json, "Print one JSON object per line instead of text");
}

void InfoCommand::Describe(const std::string& input, ImageContent content, Console& console) const
{
  InfoReport report;
  report.Input = input;
  report.Content = std::move(content);
  if (report.Content.Labels)
  {
    report.Labels = MeasureLabels(*report.Content.Labels);
  }
  console.Output() << (this->Json ? report.Json() + '\n' : report.Text());
}

void InfoCommand::RecordLost(const std::string& input, const std::string& status,
                             const std::string& message, Console& console) const
{
  console.Error(message);
  if (this->Json)
  {
    console.Output() << InfoReport::FailureJson(input, status, message) << '\n';
  }
}

void InfoCommand::Attempt(const std::string& input, const std::function<void()>& describe,
                          Console& console)
{
  ++this->Tally.Cases;
  try
  {
    describe();
  }
  catch (const InputError& error)
  {
    ++this->Tally.BadInputs;
    this->RecordLost(input, "bad-input", error.what(), console);
  }
  catch (const std::exception& error)
  {
    if (!SaysMemoryIsShort(error))
    {
      throw;
    }
    ++this->Tally.Failures;
    this->RecordLost(input, "failed",
                     input + " needs more memory than there is; crop or resample it.", console);
  }
}

// Masks of a folder are one segmentation if they are structures of one patient, else a file each.
bool InfoCommand::DescribeAsOne(const std::string& input, Console& console)
{
  if (!IsMaskFolder(input))
  {
    return false;
  }
  std::optional<MaskFolder> folder;
  try
  {
    folder.emplace(input, this->Images.Choice(), true);
  }
  catch (const InputError&)
  {
    return false; // each file has its own message
  }
  if (!folder->IsOneSegmentation())
  {
    return false;
  }
  for (const RefusedMask& mask : folder->LeftOut())
  {
    this->Attempt(
        input, [&] { throw InputError(mask.Message); }, console);
  }
  ImageContent content;
  content.Kind = "folder of masks";
  content.KindReason = folder->Why();
  content.Labels = folder->Structures();
  this->Attempt(
      input, [&] { this->Describe(input, content, console); }, console);
  return true;
}

int InfoCommand::Run(Console& console)
{
  this->Tally = {};
  for (const std::string& input : this->Inputs)
  {
    if (this->DescribeAsOne(input, console))
    {
      continue;
    }
    for (const std::string& file : WithMasksOfFolders({input}))
    {
      this->Attempt(
          file,
          [&] { this->Describe(file, ReadImageContent(file, this->Images.Choice()), console); },
          console);
    }
  }
  return this->Tally.ExitCode();
}
} // namespace palpate::cli
