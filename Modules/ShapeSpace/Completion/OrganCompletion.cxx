#include "OrganCompletion.h"

#include "DeviationMap.h"
#include "SurfaceCompletion.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr int CandidateFrequency = 6; // 362 places

template <typename Completion>
bool DescribeJudged(const Completion& completion, OrganCompletion& made)
{
  made.Model = completion.Model();
  made.Distance = completion.Distance();
  made.LargestDistance = completion.LargestDistance();
  made.PriorCases = completion.Prior()->Cases();
  made.Judgement = completion.Judge();
  return made.Judgement.IsOk();
}

Status CompleteBy(std::shared_ptr<const ShapePrior> prior, const CompletionRequest& request,
                  OrganCompletion& made)
{
  if (request.Known)
  {
    return Status::Failure("the prior is of radial models, which relate to no other organ");
  }
  std::unique_ptr<ShapeCompletion> completion;
  Status status =
      CompleteSurface(request.Touches, std::move(prior), request.ClickWorld, completion);
  if (status.IsOk())
  {
    made = DescribeCompletion(*completion, request.Frequency, request.NextCount);
  }
  return status;
}

Status StartBy(const std::shared_ptr<const SurfacePrior>& prior, const CompletionRequest& request,
               std::unique_ptr<SurfaceCompletion>& made)
{
  if (request.Known)
  {
    return SurfaceCompletion::WithKnown(prior, *request.Known, made);
  }
  const std::optional<Vector3> click =
      request.ClickWorld ? request.ClickWorld : MiddleOf(request.Touches);
  if (!click || !click->allFinite())
  {
    return Status::Failure("there is no touched point and no centre");
  }
  made = std::make_unique<SurfaceCompletion>(prior, *click);
  return Status::Success();
}

Status CompleteBy(const std::shared_ptr<const SurfacePrior>& prior,
                  const CompletionRequest& request, OrganCompletion& made)
{
  std::unique_ptr<SurfaceCompletion> completion;
  Status status = StartBy(prior, request, completion);
  if (status.IsOk())
  {
    status = completion->Update(request.Touches);
  }
  if (status.IsOk() && DescribeJudged(*completion, made))
  {
    made.Deviations = completion->Deviations(request.Frequency);
    made.Next = completion->NextTouches(request.NextCount);
  }
  return status;
}
} // namespace

OrganCompletion DescribeCompletion(const ShapeCompletion& completion, int frequency, int nextCount)
{
  OrganCompletion made;
  if (DescribeJudged(completion, made))
  {
    made.Deviations = DeviationMap(completion.Prior(), frequency).Evaluate(completion);
    made.Next =
        DeviationMap(completion.Prior(), CandidateFrequency).NextTouches(completion, nextCount);
  }
  return made;
}

Status CompleteOrgan(const CompletionRequest& request, OrganCompletion& made)
{
  return std::visit([&](const auto& prior) { return CompleteBy(prior, request, made); },
                    request.Prior);
}
} // namespace palpate
