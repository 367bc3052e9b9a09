#include "StudyPipeline.h"

#include "InputError.h"
#include "SceneLabels.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
StudyStepState Failed(const std::string& message)
{
  return {StudyStepState::Kind::Failed, 0.0, {}, message};
}

// The state of a failed node: replaced if it has a replacement.
StudyStepState Lost(const SceneNode& node, const std::string& message)
{
  return node.Advice.empty() ? Failed(message)
                             : StudyStepState{StudyStepState::Kind::Replaced, 0.0, {}, node.Advice};
}

StudyStepState Simply(StudyStepState::Kind kind)
{
  return {kind, 0.0, {}, {}};
}

// The first volume has the number 0.
std::filesystem::path FileOfVolume(const StudyState& state, int id)
{
  const StudyVolume* further = FindVolume(state, id);
  return id == 0 ? state.VolumeFile : further != nullptr ? further->File : std::filesystem::path();
}
} // namespace

const char* NameOf(StudyStepState::Kind kind)
{
  constexpr std::array<const char*, 6> Names{"not wanted",      "up to date", "replaced",
                                             "needs an update", "failed",     "running"};
  return Names.at(static_cast<std::size_t>(kind));
}

StudyPipeline::StudyPipeline(StudyJobs& jobs, std::size_t mostBytes) : Jobs(jobs), Cache(mostBytes)
{
}

StudyPipeline::~StudyPipeline()
{
  for (const auto& [key, id] : this->Running)
  {
    this->Jobs.Cancel(id);
  }
}

void StudyPipeline::Update(const StudyState& state)
{
  for (auto shown = this->Shown.begin(); shown != this->Shown.end();)
  {
    const bool isStale = this->IsOfOtherFile(shown->first, state);
    this->ShownCount += isStale ? 1 : 0;
    shown = isStale ? this->Shown.erase(shown) : std::next(shown);
  }
  this->State = state;
  this->Stamps = StampFiles(state);
  this->Advance();
}

// Whether the place belongs to another file in the next state.
bool StudyPipeline::IsOfOtherFile(const Place& place, const StudyState& next) const
{
  switch (place.first)
  {
  case SceneStep::Volume:
    return FileOfVolume(next, place.second) != FileOfVolume(this->State, place.second);
  case SceneStep::Tool:
    return next.Tool.File != this->State.Tool.File;
  default:
    break;
  }
  const SceneStructure* before = FindStructure(this->State, place.second);
  const SceneStructure* after = FindStructure(next, place.second);
  return before == nullptr || after == nullptr
             ? next.SegmentationFile != this->State.SegmentationFile
             : before->File != after->File;
}

// Starts and cancels jobs after a change of the state or of a product.
void StudyPipeline::Advance()
{
  this->Plan = PlanStudy(this->State, this->Stamps,
                         [this](const std::string& key)
                         {
                           const SceneProduct* product = this->ProductOf(key);
                           return product != nullptr ? product : this->Cache.Find(key);
                         });
  this->TakeFromCache();
  this->ForgetWhatIsNotWanted();
  for (const SceneNode& node : this->Plan)
  {
    if (this->IsReady(node))
    {
      this->Start(node);
    }
  }
}

void StudyPipeline::TakeFromCache()
{
  std::unordered_map<std::string, SceneProduct> wanted;
  for (const SceneNode& node : this->Plan)
  {
    const SceneProduct* product = this->ProductOf(node.Key);
    product = product != nullptr ? product : this->Cache.Find(node.Key);
    if (product != nullptr)
    {
      wanted.emplace(node.Key, *product);
      this->Show(node, *product);
    }
  }
  this->Current = std::move(wanted);
}

void StudyPipeline::ForgetWhatIsNotWanted()
{
  std::set<std::string> keys;
  std::set<Place> places;
  for (const SceneNode& node : this->Plan)
  {
    keys.insert(node.Key);
    places.insert({node.Step, node.Id});
  }
  for (auto run = this->Running.begin(); run != this->Running.end();)
  {
    const bool isWanted = keys.count(run->first) > 0;
    if (!isWanted)
    {
      this->Jobs.Cancel(run->second);
    }
    run = isWanted ? std::next(run) : this->Running.erase(run);
  }
  for (auto held = this->Held.begin(); held != this->Held.end();)
  {
    held = keys.count(*held) > 0 ? std::next(held) : this->Held.erase(held);
  }
  for (auto shown = this->Shown.begin(); shown != this->Shown.end();)
  {
    const bool isWanted = places.count(shown->first) > 0;
    this->ShownCount += isWanted ? 0 : 1;
    shown = isWanted ? std::next(shown) : this->Shown.erase(shown);
  }
}

bool StudyPipeline::IsReady(const SceneNode& node) const
{
  const bool isOpen = !node.Key.empty() && this->ProductOf(node.Key) == nullptr &&
                      this->Running.count(node.Key) == 0 && this->Held.count(node.Key) == 0;
  return isOpen && std::all_of(node.Inputs.begin(), node.Inputs.end(),
                               [this](const std::string& input)
                               {
                                 const SceneProduct* product = this->ProductOf(input);
                                 return product != nullptr && FailureOf(*product).empty();
                               });
}

void StudyPipeline::Start(const SceneNode& node)
{
  std::vector<SceneProduct> inputs;
  for (const std::string& input : node.Inputs)
  {
    inputs.push_back(*this->ProductOf(input));
  }
  StudyJob job;
  job.Work = [this, key = node.Key, make = node.Make,
              inputs = std::move(inputs)](const ProgressFunction& progress)
  {
    // `this` may only be used on the owner's thread, which delivers.
    return StudyJob::Delivery([this, key, product = make(inputs, progress)]
                              { this->Finish(key, product); });
  };
  job.Fail = [this, key = node.Key](const std::string& message)
  { this->Finish(key, SceneFailure{message}); };
  this->Running[node.Key] = this->Jobs.Start(std::move(job));
  ++this->Started;
}

void StudyPipeline::Finish(const std::string& key, SceneProduct product)
{
  this->Running.erase(key);
  this->Cache.Store(key, std::move(product));
  this->Advance();
}

void StudyPipeline::Show(const SceneNode& node, const SceneProduct& product)
{
  const Place place{node.Step, node.Id};
  const auto shown = this->Shown.find(place);
  if (std::holds_alternative<SceneFailure>(product))
  {
    this->ShownCount += this->Shown.erase(place);
  }
  else if (shown == this->Shown.end() || !(shown->second == product)) // by address
  {
    this->Shown[place] = product;
    ++this->ShownCount;
  }
}

const SceneProduct* StudyPipeline::ProductOf(const std::string& key) const
{
  const auto found = this->Current.find(key);
  return found != this->Current.end() ? &found->second : nullptr;
}

std::string StudyPipeline::InputFailureOf(const SceneNode& node) const
{
  for (const SceneNode& before : this->Plan)
  {
    const bool isInput = !before.Key.empty() && std::find(node.Inputs.begin(), node.Inputs.end(),
                                                          before.Key) != node.Inputs.end();
    if (isInput)
    {
      const SceneProduct* product = this->ProductOf(before.Key);
      const std::string failure =
          product != nullptr ? FailureOf(*product) : this->InputFailureOf(before);
      if (!failure.empty())
      {
        return failure;
      }
    }
  }
  return {};
}

bool StudyPipeline::IsCancelled(const SceneNode& node) const
{
  const auto isOfCancelled = [&](const SceneNode& before)
  {
    const bool isInput = !before.Key.empty() && std::find(node.Inputs.begin(), node.Inputs.end(),
                                                          before.Key) != node.Inputs.end();
    return isInput && this->IsCancelled(before);
  };
  return this->Held.count(node.Key) > 0 ||
         std::any_of(this->Plan.begin(), this->Plan.end(), isOfCancelled);
}

StudyStepState StudyPipeline::StateOf(const SceneNode& node) const
{
  if (const SceneProduct* product = this->ProductOf(node.Key))
  {
    const std::string failure = FailureOf(*product);
    return failure.empty() ? Simply(StudyStepState::Kind::UpToDate) : Lost(node, failure);
  }
  const auto run = this->Running.find(node.Key);
  const auto progress =
      run != this->Running.end() ? this->Jobs.ProgressOf(run->second) : std::nullopt;
  if (progress && progress->IsRunning)
  {
    return {StudyStepState::Kind::Running, progress->Fraction, progress->Stage, {}};
  }
  const std::string failure = this->InputFailureOf(node);
  if (!failure.empty())
  {
    return Lost(node, failure);
  }
  StudyStepState waiting = Simply(StudyStepState::Kind::NeedsUpdate);
  waiting.IsCancelled = this->IsCancelled(node);
  return waiting;
}

StudyStepState StudyPipeline::StateOfStructure(int id) const
{
  const SceneStructure* structure = FindStructure(this->State, id);
  if (structure == nullptr || structure->Source() != SceneSource::Label)
  {
    return Simply(StudyStepState::Kind::UpToDate);
  }
  const auto node =
      std::find_if(this->Plan.begin(), this->Plan.end(),
                   [structure](const SceneNode& one)
                   { return one.Step == SceneStep::Segmentation && one.Reads == structure->File; });
  if (node == this->Plan.end())
  {
    return {};
  }
  const StudyStepState whole = this->StateOf(*node);
  const auto segmentation = ProductAs<Segmentation>(this->ProductOf(node->Key));
  if (whole.Is != StudyStepState::Kind::UpToDate || segmentation == nullptr)
  {
    return whole.Is == StudyStepState::Kind::Running ? Simply(StudyStepState::Kind::NeedsUpdate)
                                                     : whole;
  }
  try
  {
    SegmentOf(*structure, *segmentation);
    return Simply(StudyStepState::Kind::UpToDate);
  }
  catch (const InputError& error)
  {
    return Failed(error.what());
  }
}

StudyStepState StudyPipeline::StateOf(SceneStep step, int id) const
{
  if (step == SceneStep::Structures)
  {
    return this->StateOfStructure(id);
  }
  for (const SceneNode& node : this->Plan)
  {
    if (node.Step == step && node.Id == id)
    {
      return this->StateOf(node);
    }
  }
  return {};
}

StudyStepState StudyPipeline::StateOf(SceneStep step) const
{
  using Kind = StudyStepState::Kind;
  StudyStepState worst;
  double all = 0.0;
  std::size_t wanted = 0;
  std::size_t done = 0;
  bool isCancelled = false;
  const auto add = [&](int id)
  {
    const StudyStepState one = this->StateOf(step, id);
    const bool isOpen = one.Is == Kind::Running || one.Is == Kind::NeedsUpdate;
    const bool isDone = one.Is != Kind::NotWanted && !isOpen;
    wanted += one.Is != Kind::NotWanted ? 1 : 0;
    done += isDone ? 1 : 0;
    all += isDone ? 1.0 : one.Fraction;
    isCancelled = isCancelled || one.IsCancelled;
    worst = one.Is > worst.Is ? one : worst;
  };
  if (step == SceneStep::Volume || step == SceneStep::Segmentation || step == SceneStep::Tool)
  {
    add(0);
  }
  if (step == SceneStep::Volume)
  {
    std::for_each(this->State.Volumes.begin(), this->State.Volumes.end(),
                  [&](const StudyVolume& volume) { add(volume.Id); });
  }
  else
  {
    std::for_each(this->State.Structures.begin(), this->State.Structures.end(),
                  [&](const SceneStructure& structure) { add(structure.Id); });
  }
  worst.Fraction = wanted > 0 ? all / static_cast<double>(wanted) : 0.0;
  worst.IsCancelled = isCancelled;
  worst.Wanted = wanted;
  worst.Done = done;
  return worst;
}

std::vector<std::string> StudyPipeline::Advice() const
{
  std::vector<std::string> messages;
  for (const SceneNode& node : this->Plan)
  {
    const bool isTrue = !node.Advice.empty() && this->ProductOf(node.Replacement) != nullptr;
    if (isTrue && (messages.empty() || messages.back() != node.Advice))
    {
      messages.push_back(node.Advice);
    }
  }
  return messages;
}

template <typename Do>
void StudyPipeline::ForEachNode(SceneStep step, const Do& act)
{
  for (const SceneNode& node : this->Plan)
  {
    if (node.Step == step && !node.Key.empty())
    {
      act(node);
    }
  }
}

void StudyPipeline::Cancel(SceneStep step)
{
  this->ForEachNode(step,
                    [this](const SceneNode& node)
                    {
                      if (this->ProductOf(node.Key) == nullptr)
                      {
                        this->Held.insert(node.Key);
                      }
                      const auto run = this->Running.find(node.Key);
                      if (run != this->Running.end())
                      {
                        this->Jobs.Cancel(run->second);
                        this->Running.erase(run);
                      }
                    });
}

void StudyPipeline::Resume(SceneStep step)
{
  this->ForEachNode(step, [this](const SceneNode& node) { this->Held.erase(node.Key); });
  this->Advance();
}

void StudyPipeline::Retry(SceneStep step)
{
  this->ForEachNode(step,
                    [this](const SceneNode& node)
                    {
                      const SceneProduct* product = this->ProductOf(node.Key);
                      if (product != nullptr && !FailureOf(*product).empty())
                      {
                        this->Current.erase(node.Key);
                        this->Cache.Forget(node.Key);
                      }
                    });
  this->Advance();
}
} // namespace palpate
