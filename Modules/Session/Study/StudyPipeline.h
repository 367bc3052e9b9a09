#pragma once

#include "PalpateSessionModule.h"
#include "StudyCache.h"
#include "StudyJobs.h"
#include "StudyPlan.h"
#include "StudyState.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace palpate
{
/// How a step stands.
struct StudyStepState
{
  enum class Kind
  {
    NotWanted, ///< nothing shown or touched needs it
    UpToDate,
    Replaced,    ///< it failed, and something else does its work; Sentence says what, and why
    NeedsUpdate, ///< waits for what comes before it, for its turn, or for Resume
    Failed,      ///< Sentence says why
    Running
  };
  Kind Is = Kind::NotWanted;
  double Fraction = 0.0; ///< while running
  std::string Stage;     ///< while running, in one word
  std::string Sentence;  ///< why it failed, or what replaces it
  /// It needs an update that does not come by itself, since it or what it waits for was cancelled.
  bool IsCancelled = false;
};

/// "not wanted", "up to date", ...
PALPATESESSION_EXPORT const char* NameOf(StudyStepState::Kind kind);

/// Makes what a state wants, beside the thread that owns it, and keeps what it made: a state that
/// was there before is there again at once. Nothing is made twice, and nothing for structures that
/// are neither shown nor touched. Structures are named by their label in the segmentation.
class PALPATESESSION_EXPORT StudyPipeline
{
public:
  /// Keeps the address of `jobs`, which outlive it. `mostBytes` are kept beside what the current
  /// state wants.
  explicit StudyPipeline(StudyJobs& jobs, std::size_t mostBytes = std::size_t{1} << 30);
  StudyPipeline(const StudyPipeline&) = delete;
  StudyPipeline& operator=(const StudyPipeline&) = delete;
  /// Cancels what it started.
  ~StudyPipeline();

  /// Wants what `state` wants; what is running for another one and no longer wanted is cancelled.
  /// Looks whether files were written anew.
  void Update(const StudyState& state);

  StudyStepState StateOf(StudyStep step, int label) const;
  /// Of all structures together: running where one runs, failed where one failed, and so on.
  StudyStepState StateOf(StudyStep step) const;

  /// A sentence for each structure that is touched or shown by something else than was tried first,
  /// since that failed. In the order of structures.
  std::vector<std::string> Advice() const;

  /// Stops a step and does not begin it again by itself, until Resume or other settings.
  void Cancel(StudyStep step);
  void Resume(StudyStep step);
  /// Tries again what failed.
  void Retry(StudyStep step);

  /// The newest product of a step, or nothing: while another one is being made the one before.
  template <typename T>
  std::shared_ptr<const T> Newest(StudyStep step, int label = 0) const
  {
    const auto found = this->Shown.find({step, label});
    return found != this->Shown.end() ? ProductAs<T>(&found->second) : nullptr;
  }
  /// Grows whenever a newest product is another one.
  std::uint64_t Revision() const { return this->ShownCount; }
  /// How many pieces of work it ever started.
  std::uint64_t StartedCount() const { return this->Started; }

private:
  using Place = std::pair<StudyStep, int>;

  void Advance();
  void TakeFromCache();
  void ForgetWhatIsNotWanted();
  void Start(const StudyNode& node);
  bool IsReady(const StudyNode& node) const;
  void Finish(const std::string& key, StudyProduct product);
  void Show(const StudyNode& node, const StudyProduct& product);
  const StudyProduct* ProductOf(const std::string& key) const;
  StudyStepState StateOf(const StudyNode& node) const;
  StudyStepState StateOfStructure(int label) const;
  std::string InputFailureOf(const StudyNode& node) const;
  bool IsCancelled(const StudyNode& node) const;
  template <typename Do>
  void ForEachNode(StudyStep step, const Do& act);

  StudyJobs& Jobs;
  StudyCache Cache;
  StudyState State;
  StudyStamps Stamps;
  std::vector<StudyNode> Plan;
  std::unordered_map<std::string, StudyProduct> Current; ///< of the plan, whatever the cache drops
  std::unordered_map<std::string, StudyJobs::Id> Running;
  std::set<std::string> Held; ///< cancelled by the user
  std::map<Place, StudyProduct> Shown;
  std::uint64_t ShownCount = 0;
  std::uint64_t Started = 0;
};
} // namespace palpate
