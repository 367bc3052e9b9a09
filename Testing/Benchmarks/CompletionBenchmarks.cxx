#include "CompletionBenchmarks.h"

#include "DeviationMap.h"
#include "RandomShapes.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <memory>
#include <sstream>
#include <string>

namespace palpate::bench
{
namespace
{
constexpr double CenterInformation =
    1.0 / (ShapeCompletion::CenterDeviation * ShapeCompletion::CenterDeviation);

std::shared_ptr<const ShapePrior> PriorOfOrgans()
{
  test::Random random(3);
  std::vector<RadialModel> organs;
  for (int n = 0; n < 60; ++n)
  {
    organs.push_back(test::RandomOrgan(random, 12));
  }
  ShapePrior prior;
  std::vector<std::size_t> omitted;
  const Status status = ShapePrior::OfGroup(organs, prior, omitted);
  return status.IsOk() ? std::make_shared<const ShapePrior>(prior) : nullptr;
}

// A touch that comes and goes, among others that stay.
class CompletionCase
{
public:
  explicit CompletionCase(int count)
      : Prior(PriorOfOrgans()), Completion(Prior, Vector3::Zero()), Map(Prior, 8),
        Inverse(Prior->Covariance().inverse())
  {
    test::Random random(4);
    const RadialModel organ = test::RandomOrgan(random, 12);
    for (const Vector3& direction : test::RandomDirections(random, count))
    {
      this->Touches.push_back({organ.Radius(direction) * direction, 1.0});
    }
  }

  void Update()
  {
    this->Move();
    this->Outcome = this->Completion.Update(this->Touches);
    this->Ours = this->Map.Evaluate(this->Completion);
  }

  // Gauss-Newton in the unknowns from the prior's mean, as many steps as it needs, and all of the
  // posterior covariance.
  void Refit()
  {
    const Eigen::Index count = this->Prior->Size();
    LogSurface surface{this->Prior->Mean(), Vector3::Zero()};
    TouchEquations equations(this->Prior->Degree());
    equations.SetTouches(this->Touches);
    Eigen::MatrixXd slopes(equations.Rows(), count + 3);
    Eigen::MatrixXd information;
    for (double change = 1.0; change > 1e-6;)
    {
      equations.Evaluate(surface);
      slopes.leftCols(count) = equations.ByCoefficients().transpose();
      slopes.rightCols<3>() = equations.ByCenter().transpose();
      information = slopes.transpose() * slopes / Variance;
      information.topLeftCorner(count, count) += this->Inverse;
      information.diagonal().tail<3>().array() += CenterInformation;
      Eigen::VectorXd gradient = slopes.transpose() * equations.Residuals() / Variance;
      gradient.head(count) += this->Inverse * (surface.Coefficients - this->Prior->Mean());
      gradient.tail<3>() += CenterInformation * surface.CenterWorld;
      const Eigen::VectorXd step = information.llt().solve(gradient);
      surface.Coefficients -= step.head(count);
      surface.CenterWorld -= step.tail<3>();
      change = step.norm();
    }
    this->Theirs = this->DeviationsOf(surface, information);
  }

  std::string Disagreement()
  {
    this->Update();
    this->Refit(); // of the same touches
    const double difference = (this->Ours - this->Theirs).cwiseAbs().maxCoeff();
    std::ostringstream text;
    if (!this->Outcome.IsOk() || !(difference < 2e-3))
    {
      text << "standard deviations differ by " << difference << " mm";
    }
    return text.str();
  }

private:
  static constexpr double Variance =
      1.0 + TouchEquations::ModelDeviation * TouchEquations::ModelDeviation;

  void Move()
  {
    this->IsMoved = !this->IsMoved;
    this->Touches.back().PointWorld *= this->IsMoved ? 1.05 : 1.0 / 1.05;
  }

  Eigen::VectorXd DeviationsOf(const LogSurface& surface, const Eigen::MatrixXd& information) const
  {
    std::vector<SurfaceTouch> points;
    const RadialModel model = RadialModelOf(surface.Coefficients, 12, surface.CenterWorld);
    for (const Vector3& direction : this->Map.Directions())
    {
      points.push_back({model.PointWorld(direction), 1.0});
    }
    TouchEquations equations(this->Prior->Degree());
    equations.SetTouches(points);
    equations.Evaluate(surface);
    Eigen::MatrixXd slopes(this->Prior->Size() + 3, equations.Rows());
    slopes.topRows(this->Prior->Size()) = equations.ByCoefficients();
    slopes.bottomRows<3>() = equations.ByCenter();
    const Eigen::MatrixXd covariance = information.llt().solve(slopes);
    return (slopes.cwiseProduct(covariance).colwise().sum().array() +
            DeviationMap::LeftOut * DeviationMap::LeftOut)
        .sqrt();
  }

  std::shared_ptr<const ShapePrior> Prior;
  ShapeCompletion Completion;
  DeviationMap Map;
  Eigen::MatrixXd Inverse;
  std::vector<SurfaceTouch> Touches;
  bool IsMoved = false;
  Status Outcome = Status::Failure("the completion did not run");
  Eigen::VectorXd Ours;
  Eigen::VectorXd Theirs;
};
} // namespace

std::vector<PairedBenchmark> CompletionBenchmarks()
{
  std::vector<PairedBenchmark> pairs;
  for (const int touches : {12, 20, 40})
  {
    const auto one = std::make_shared<CompletionCase>(touches);
    pairs.push_back({"completion/touch/" + std::to_string(touches),
                     "a refit from nothing in 172 unknowns", [one] { one->Update(); },
                     [one] { one->Refit(); }, [one] { return one->Disagreement(); }});
  }
  return pairs;
}
} // namespace palpate::bench
