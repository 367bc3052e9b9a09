#pragma once

#include "PalpateStudyModule.h"
#include "Study.h"

#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace palpate
{
/// Opens files beside what is open in a study. Each is read in the background first; then the study
/// changes, by one undo step. A file that cannot be read changes nothing. What was read is not read
/// again. Owner thread of the study only.
class PALPATESTUDY_EXPORT StudyOpening
{
public:
  /// One of these is called once, unless the opening is cancelled.
  struct Outcome
  {
    std::function<void()> Done;                           ///< the study has changed
    std::function<void(const std::string& message)> Fail; ///< it has not
  };

  /// Keeps the address.
  explicit StudyOpening(Study& study) : Open(study) {}

  /// See the study's functions of these names.
  void OpenVolume(const std::filesystem::path& file, const std::string& series, Outcome outcome);
  void AddVolume(const std::filesystem::path& file, const std::string& series, Outcome outcome);
  void OpenSegmentation(const std::filesystem::path& file, Outcome outcome);
  void AddStructure(const std::filesystem::path& file, Outcome outcome);
  void OpenScene(const std::filesystem::path& file, Outcome outcome);
  void AddMarkups(const std::filesystem::path& file, Outcome outcome);

  bool IsReading() const { return !this->Reading.empty(); }
  /// Whether and how far a file of this step (Volume, Segmentation, ...) is being read; not wanted
  /// if none is.
  StudyStepState StateOf(SceneStep step) const;
  /// Forgets the files of this step, or all files, that are being read.
  void Cancel(SceneStep step);
  void Cancel();

private:
  using Taking = std::function<void()>; // what to do with the file that was read
  void Read(SceneStep step, std::function<Taking(const ProgressFunction& progress)> read,
            Outcome outcome);
  void ReadVolume(const std::filesystem::path& file, const std::string& series, Taking take,
                  Outcome outcome);
  void ReadImage(const SceneNode& node, Taking take, Outcome outcome);

  Study& Open;
  std::map<StudyJobs::Id, SceneStep> Reading;
};
} // namespace palpate
