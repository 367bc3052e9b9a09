#pragma once

#include "PalpateStudyModule.h"
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
/// State of a step.
struct StudyStepState
{
  enum class Kind
  {
    NotWanted, ///< not needed by anything shown or touched
    UpToDate,
    Replaced,    ///< it failed, and another product replaces it; Sentence names it and the reason
    NeedsUpdate, ///< waits for its inputs, its turn, or Resume
    Failed,      ///< Sentence gives the reason
    Running
  };
  Kind Is = Kind::NotWanted;
  double Fraction = 0.0; ///< while running; of a step, over all that it makes
  std::string Stage;     ///< while running, one word
  std::string Message;   ///< why it failed, or its replacement
  /// It needs an update that will not start by itself, since it or one of its inputs was cancelled.
  bool IsCancelled = false;
  std::size_t Wanted = 0; ///< of a step: number of products
  std::size_t Done = 0;   ///< of these, no longer waiting or running
};

/// "not wanted", "up to date", ...
PALPATESTUDY_EXPORT const char* NameOf(StudyStepState::Kind kind);

/// Makes the products that a state needs, in the background, and caches them: a former state is
/// available again immediately. Each product is made only once, and none for structures that are
/// neither shown, touched nor forbidden. Structures are identified by id.
class PALPATESTUDY_EXPORT StudyPipeline
{
public:
  /// Keeps the address of `jobs`, which must outlive it. Caches up to `mostBytes` in addition to
  /// the products of the current state.
  explicit StudyPipeline(StudyJobs& jobs, std::size_t mostBytes = std::size_t{1} << 30);
  StudyPipeline(const StudyPipeline&) = delete;
  StudyPipeline& operator=(const StudyPipeline&) = delete;
  /// Cancels its jobs.
  ~StudyPipeline();

  /// Starts the products that `state` needs; cancels running jobs that it no longer needs. Checks
  /// whether files have changed.
  void Update(const StudyState& state);

  /// Keeps a product that was made elsewhere from the same inputs and settings, for the next
  /// Update.
  void Keep(const std::string& key, SceneProduct product)
  {
    this->Cache.Store(key, std::move(product));
  }

  StudyStepState StateOf(SceneStep step, int id) const;
  /// State over all structures: running if one is running, failed if one failed, and so on.
  StudyStepState StateOf(SceneStep step) const;

  /// One message per structure whose touch or display was replaced since the first choice failed,
  /// in the order of structures.
  std::vector<std::string> Advice() const;

  /// Stops a step; it does not restart until Resume or until settings change.
  void Cancel(SceneStep step);
  void Resume(SceneStep step);
  /// Retries failed work.
  void Retry(SceneStep step);

  /// The newest product of a step, or null; the previous one while another is being made.
  template <typename T>
  std::shared_ptr<const T> Newest(SceneStep step, int id = 0) const
  {
    return ProductAs<T>(this->NewestProduct(step, id));
  }
  /// The same, of any type; null if there is none.
  const SceneProduct* NewestProduct(SceneStep step, int id) const
  {
    const auto found = this->Shown.find({step, id});
    return found != this->Shown.end() ? &found->second : nullptr;
  }
  /// Increases whenever a newest product changes.
  std::uint64_t Revision() const { return this->ShownCount; }
  /// Total number of jobs started.
  std::uint64_t StartedCount() const { return this->Started; }

private:
  using Place = std::pair<SceneStep, int>;

  bool IsOfOtherFile(const Place& place, const StudyState& next) const;
  void Advance();
  void TakeFromCache();
  void ForgetWhatIsNotWanted();
  void Start(const SceneNode& node);
  bool IsReady(const SceneNode& node) const;
  void Finish(const std::string& key, SceneProduct product);
  void Show(const SceneNode& node, const SceneProduct& product);
  const SceneProduct* ProductOf(const std::string& key) const;
  StudyStepState StateOf(const SceneNode& node) const;
  StudyStepState StateOfStructure(int id) const;
  std::string InputFailureOf(const SceneNode& node) const;
  bool IsCancelled(const SceneNode& node) const;
  template <typename Do>
  void ForEachNode(SceneStep step, const Do& act);

  StudyJobs& Jobs;
  StudyCache Cache;
  StudyState State;
  SceneStamps Stamps;
  std::vector<SceneNode> Plan;
  std::unordered_map<std::string, SceneProduct> Current; ///< of the plan, never dropped
  std::unordered_map<std::string, StudyJobs::Id> Running;
  std::set<std::string> Held; ///< cancelled by the user
  std::map<Place, SceneProduct> Shown;
  std::uint64_t ShownCount = 0;
  std::uint64_t Started = 0;
};
} // namespace palpate
