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
PALPATESTUDY_EXPORT const char* NameOf(StudyStepState::Kind kind);

/// Makes what a state wants, beside the thread that owns it, and keeps what it made: a state that
/// was there before is there again at once. Nothing is made twice, and nothing for structures that
/// are neither shown nor touched. Structures are named by their id.
class PALPATESTUDY_EXPORT StudyPipeline
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

  StudyStepState StateOf(SceneStep step, int id) const;
  /// Of all structures together: running where one runs, failed where one failed, and so on.
  StudyStepState StateOf(SceneStep step) const;

  /// A sentence for each structure that is touched or shown by something else than was tried first,
  /// since that failed. In the order of structures.
  std::vector<std::string> Advice() const;

  /// Stops a step and does not begin it again by itself, until Resume or other settings.
  void Cancel(SceneStep step);
  void Resume(SceneStep step);
  /// Tries again what failed.
  void Retry(SceneStep step);

  /// The newest product of a step, or nothing: while another one is being made the one before.
  template <typename T>
  std::shared_ptr<const T> Newest(SceneStep step, int id = 0) const
  {
    return ProductAs<T>(this->NewestProduct(step, id));
  }
  /// The same whatever its type; null where there is none.
  const SceneProduct* NewestProduct(SceneStep step, int id) const
  {
    const auto found = this->Shown.find({step, id});
    return found != this->Shown.end() ? &found->second : nullptr;
  }
  /// Grows whenever a newest product is another one.
  std::uint64_t Revision() const { return this->ShownCount; }
  /// How many pieces of work it ever started.
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
  std::unordered_map<std::string, SceneProduct> Current; ///< of the plan, whatever the cache drops
  std::unordered_map<std::string, StudyJobs::Id> Running;
  std::set<std::string> Held; ///< cancelled by the user
  std::map<Place, SceneProduct> Shown;
  std::uint64_t ShownCount = 0;
  std::uint64_t Started = 0;
};
} // namespace palpate
