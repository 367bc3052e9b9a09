#include "OrganCompletion.h"

#include "DeviationMap.h"

#include <utility>

namespace palpate
{
namespace
{
constexpr int CandidateFrequency = 6; // 362 places

Eigen::VectorXd DeviationsOf(const ShapeCompletion& completion, int frequency)
{
  return DeviationMap(completion.Prior(), frequency).Evaluate(completion);
}

Eigen::VectorXd DeviationsOf(const SurfaceCompletion& completion, int frequency)
{
  return completion.Deviations(frequency);
}

std::vector<Vector3> NextOf(const ShapeCompletion& completion, int count)
{
  return DeviationMap(completion.Prior(), CandidateFrequency).NextTouches(completion, count);
}

std::vector<Vector3> NextOf(const SurfaceCompletion& completion, int count)
{
  return completion.NextTouches(count);
}

Status StartBy(const std::shared_ptr<const ShapePrior>& prior, const CompletionRequest& request,
               StartedCompletion& made)
{
  if (request.Known)
  {
    return Status::Failure("the prior is of radial models, which relate to no other organ");
  }
  std::unique_ptr<ShapeCompletion> started;
  Status status = CompleteSurface(request.Touches, prior, request.ClickWorld, started);
  if (status.IsOk())
  {
    made = std::shared_ptr<ShapeCompletion>(std::move(started));
  }
  return status;
}

Status StartBy(const std::shared_ptr<const SurfacePrior>& prior, const CompletionRequest& request,
               StartedCompletion& made)
{
  std::unique_ptr<SurfaceCompletion> started;
  Status status = Status::Success();
  const std::optional<Vector3> click =
      request.ClickWorld ? request.ClickWorld : MiddleOf(request.Touches);
  if (request.Known)
  {
    status = SurfaceCompletion::WithKnown(prior, *request.Known, started);
  }
  else if (!click || !click->allFinite())
  {
    status = Status::Failure("there is no touched point and no centre");
  }
  else
  {
    started = std::make_unique<SurfaceCompletion>(prior, *click);
  }
  status = status.IsOk() ? started->Update(request.Touches) : status;
  if (status.IsOk())
  {
    made = std::shared_ptr<SurfaceCompletion>(std::move(started));
  }
  return status;
}
} // namespace

Status StartCompletion(const CompletionRequest& request, StartedCompletion& made)
{
  return std::visit([&](const auto& prior) { return StartBy(prior, request, made); },
                    request.Prior);
}

OrganCompletion DescribeCompletion(const StartedCompletion& completion, int frequency,
                                   int nextCount)
{
  OrganCompletion made;
  std::visit(
      [&](const auto& one)
      {
        made.Model = one->Model();
        made.Distance = one->Distance();
        made.LargestDistance = one->LargestDistance();
        made.PriorCases = one->Prior()->Cases();
        made.Judgement = one->Judge();
        if (made.Judgement.IsOk())
        {
          made.Deviations = DeviationsOf(*one, frequency);
          made.Next = NextOf(*one, nextCount);
        }
      },
      completion);
  return made;
}

Status CompleteOrgan(const CompletionRequest& request, OrganCompletion& made)
{
  StartedCompletion completion;
  Status status = StartCompletion(request, completion);
  if (status.IsOk())
  {
    made = DescribeCompletion(completion, request.Frequency, request.NextCount);
  }
  return status;
}
} // namespace palpate
