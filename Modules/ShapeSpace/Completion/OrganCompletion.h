#pragma once

#include "ShapeCompletion.h"
#include "ShapePrior.h"
#include "SurfaceCompletion.h"
#include "SurfaceTouch.h"

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace palpate
{
/// Of radial or of surface models. A null prior of radial models: smoothness alone.
using OrganPrior =
    std::variant<std::shared_ptr<const ShapePrior>, std::shared_ptr<const SurfacePrior>>;

/// Lengths mm, patient LPS.
struct CompletionRequest
{
  std::vector<SurfaceTouch> Touches;
  OrganPrior Prior;
  /// Near the organ's centre; none: the middle of the touches' box. Not used with Known.
  std::optional<Vector3> ClickWorld = std::nullopt;
  /// The other organ (FindLogSurface) that a prior of surface models relates to.
  std::optional<LogSurface> Known = std::nullopt;
  int Frequency = 20; ///< of the points whose standard deviations are wanted
  int NextCount = 6;  ///< places to touch next
};

/// An organ's most probable surface, of either kind: a radial model, or a surface model.
struct OrganCompletion
{
  OrganModel Model;
  std::size_t PriorCases = 0;           ///< 0: smoothness alone
  double Distance = 0.0;                ///< RMS of the touches from the surface
  double LargestDistance = 0.0;         ///< above which it is refused
  Status Judgement = Status::Success(); ///< why it is refused; then the rest is empty
  Eigen::VectorXd Deviations;           ///< standard deviations along the normals
  std::vector<Vector3> Next;            ///< where to touch next, the first one first
};

/// A completion of either kind, which goes on by Update. Never null.
using StartedCompletion =
    std::variant<std::shared_ptr<ShapeCompletion>, std::shared_ptr<SurfaceCompletion>>;

/// Starts ShapeCompletion or SurfaceCompletion, and completes by the touches so far. Fails, and
/// leaves `made`, for touches and priors that they refuse.
Status StartCompletion(const CompletionRequest& request, StartedCompletion& made);
/// The judgement, and the rest unless the completion is refused.
OrganCompletion DescribeCompletion(const StartedCompletion& completion, int frequency,
                                   int nextCount);

/// Both in one call. A surface that is found but not believed is a Judgement.
Status CompleteOrgan(const CompletionRequest& request, OrganCompletion& made);
} // namespace palpate
