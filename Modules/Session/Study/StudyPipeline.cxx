#include "StudyPipeline.h"

#include "InputError.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
StudyStepState Failed(const std::string& sentence)
{
  return {StudyStepState::Kind::Failed, 0.0, {}, sentence};
}

// What has failed, unless something else does its work.
StudyStepState Lost(const StudyNode& node, const std::string& sentence)
{
  return node.Advice.empty() ? Failed(sentence)
                             : StudyStepState{StudyStepState::Kind::Replaced, 0.0, {}, node.Advice};
}

StudyStepState Simply(StudyStepState::Kind kind)
{
  return {kind, 0.0, {}, {}};
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
  const bool isOtherVolume = state.VolumeFile != this->State.VolumeFile;
  const bool isOtherSegmentation = state.SegmentationFile != this->State.SegmentationFile;
  const bool isOtherTool = state.Tool.File != this->State.Tool.File;
  for (auto shown = this->Shown.begin(); shown != this->Shown.end();)
  {
    const StudyStep step = shown->first.first;
    const bool isStale = step == StudyStep::Volume ? isOtherVolume
                         : step == StudyStep::Tool ? isOtherTool
                                                   : isOtherSegmentation;
    this->ShownCount += isStale ? 1 : 0;
    shown = isStale ? this->Shown.erase(shown) : std::next(shown);
  }
  this->State = state;
  this->Stamps = StampFiles(state);
  this->Advance();
}

// What to do now that the state or a product is another one.
void StudyPipeline::Advance()
{
  this->Plan = PlanStudy(this->State, this->Stamps,
                         [this](const std::string& key)
                         {
                           const StudyProduct* product = this->ProductOf(key);
                           return product != nullptr ? product : this->Cache.Find(key);
                         });
  this->TakeFromCache();
  this->ForgetWhatIsNotWanted();
  for (const StudyNode& node : this->Plan)
  {
    if (this->IsReady(node))
    {
      this->Start(node);
    }
  }
}

void StudyPipeline::TakeFromCache()
{
  std::unordered_map<std::string, StudyProduct> wanted;
  for (const StudyNode& node : this->Plan)
  {
    const StudyProduct* product = this->ProductOf(node.Key);
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
  for (const StudyNode& node : this->Plan)
  {
    keys.insert(node.Key);
    places.insert({node.Step, node.Label});
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

bool StudyPipeline::IsReady(const StudyNode& node) const
{
  const bool isOpen = !node.Key.empty() && this->ProductOf(node.Key) == nullptr &&
                      this->Running.count(node.Key) == 0 && this->Held.count(node.Key) == 0;
  return isOpen && std::all_of(node.Inputs.begin(), node.Inputs.end(),
                               [this](const std::string& input)
                               {
                                 const StudyProduct* product = this->ProductOf(input);
                                 return product != nullptr && FailureOf(*product).empty();
                               });
}

void StudyPipeline::Start(const StudyNode& node)
{
  std::vector<StudyProduct> inputs;
  for (const std::string& input : node.Inputs)
  {
    inputs.push_back(*this->ProductOf(input));
  }
  StudyJob job;
  job.Work = [this, key = node.Key, make = node.Make,
              inputs = std::move(inputs)](const ProgressFunction& progress)
  {
    // What `this` is belongs to the owner's thread, which alone delivers.
    return StudyJob::Delivery([this, key, product = make(inputs, progress)]
                              { this->Finish(key, product); });
  };
  job.Fail = [this, key = node.Key](const std::string& sentence)
  { this->Finish(key, StudyFailure{sentence}); };
  this->Running[node.Key] = this->Jobs.Start(std::move(job));
  ++this->Started;
}

void StudyPipeline::Finish(const std::string& key, StudyProduct product)
{
  this->Running.erase(key);
  this->Cache.Store(key, std::move(product));
  this->Advance();
}

void StudyPipeline::Show(const StudyNode& node, const StudyProduct& product)
{
  const Place place{node.Step, node.Label};
  const auto shown = this->Shown.find(place);
  if (std::holds_alternative<StudyFailure>(product))
  {
    this->ShownCount += this->Shown.erase(place);
  }
  else if (shown == this->Shown.end() || !(shown->second == product)) // by address
  {
    this->Shown[place] = product;
    ++this->ShownCount;
  }
}

const StudyProduct* StudyPipeline::ProductOf(const std::string& key) const
{
  const auto found = this->Current.find(key);
  return found != this->Current.end() ? &found->second : nullptr;
}

std::string StudyPipeline::InputFailureOf(const StudyNode& node) const
{
  for (const StudyNode& before : this->Plan)
  {
    const bool isInput = !before.Key.empty() && std::find(node.Inputs.begin(), node.Inputs.end(),
                                                          before.Key) != node.Inputs.end();
    if (isInput)
    {
      const StudyProduct* product = this->ProductOf(before.Key);
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

bool StudyPipeline::IsCancelled(const StudyNode& node) const
{
  const auto isOfCancelled = [&](const StudyNode& before)
  {
    const bool isInput = !before.Key.empty() && std::find(node.Inputs.begin(), node.Inputs.end(),
                                                          before.Key) != node.Inputs.end();
    return isInput && this->IsCancelled(before);
  };
  return this->Held.count(node.Key) > 0 ||
         std::any_of(this->Plan.begin(), this->Plan.end(), isOfCancelled);
}

StudyStepState StudyPipeline::StateOf(const StudyNode& node) const
{
  if (const StudyProduct* product = this->ProductOf(node.Key))
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

StudyStepState StudyPipeline::StateOfStructure(int label) const
{
  const StudyStepState whole = this->StateOf(StudyStep::Segmentation, 0);
  const auto segmentation = this->Newest<Segmentation>(StudyStep::Segmentation);
  if (whole.Is != StudyStepState::Kind::UpToDate || segmentation == nullptr)
  {
    return whole.Is == StudyStepState::Kind::Running ? Simply(StudyStepState::Kind::NeedsUpdate)
                                                     : whole;
  }
  try
  {
    segmentation->Find(std::to_string(label));
    return Simply(StudyStepState::Kind::UpToDate);
  }
  catch (const InputError& error)
  {
    return Failed(error.what());
  }
}

StudyStepState StudyPipeline::StateOf(StudyStep step, int label) const
{
  if (step == StudyStep::Structures)
  {
    return this->StateOfStructure(label);
  }
  for (const StudyNode& node : this->Plan)
  {
    if (node.Step == step && node.Label == label)
    {
      return this->StateOf(node);
    }
  }
  return {};
}

StudyStepState StudyPipeline::StateOf(StudyStep step) const
{
  if (step == StudyStep::Volume || step == StudyStep::Segmentation || step == StudyStep::Tool)
  {
    return this->StateOf(step, 0);
  }
  StudyStepState worst;
  for (const StudyStructure& structure : this->State.Structures)
  {
    const StudyStepState one = this->StateOf(step, structure.Label);
    worst = one.Is > worst.Is ? one : worst;
  }
  return worst;
}

std::vector<std::string> StudyPipeline::Advice() const
{
  std::vector<std::string> sentences;
  for (const StudyNode& node : this->Plan)
  {
    const bool isTrue = !node.Advice.empty() && this->ProductOf(node.Replacement) != nullptr;
    if (isTrue && (sentences.empty() || sentences.back() != node.Advice))
    {
      sentences.push_back(node.Advice);
    }
  }
  return sentences;
}

template <typename Do>
void StudyPipeline::ForEachNode(StudyStep step, const Do& act)
{
  for (const StudyNode& node : this->Plan)
  {
    if (node.Step == step && !node.Key.empty())
    {
      act(node);
    }
  }
}

void StudyPipeline::Cancel(StudyStep step)
{
  this->ForEachNode(step,
                    [this](const StudyNode& node)
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

void StudyPipeline::Resume(StudyStep step)
{
  this->ForEachNode(step, [this](const StudyNode& node) { this->Held.erase(node.Key); });
  this->Advance();
}

void StudyPipeline::Retry(StudyStep step)
{
  this->ForEachNode(step,
                    [this](const StudyNode& node)
                    {
                      const StudyProduct* product = this->ProductOf(node.Key);
                      if (product != nullptr && !FailureOf(*product).empty())
                      {
                        this->Current.erase(node.Key);
                        this->Cache.Forget(node.Key);
                      }
                    });
  this->Advance();
}
} // namespace palpate
