#include "StiffnessCondensation.h"

#include "DenseFront.h"
#include "SingleBlasThread.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <future>
#include <new>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr const char* NotDefinite = "The equations of elasticity have no definite solution.";

// The equations in the order of elimination. Without pivots a singular matrix shows by its
// solutions: load 0 is one whose solution is known.
struct OrderedEquations
{
  OrderedEquations(const StiffnessMatrix& lowerTriangle, const NestedDissection& order,
                   const LoadMatrix& loads)
      : Loads(&loads), Lower(lowerTriangle.rows(), lowerTriangle.cols()),
        Truth(Eigen::VectorXd::LinSpaced(lowerTriangle.rows(), 1.0, 2.0)),
        Known(lowerTriangle.selfadjointView<Eigen::Lower>() * Truth)
  {
    Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, int> places(lowerTriangle.rows());
    for (const int node : order.Order())
    {
      for (int c = 0; c < 3; ++c)
      {
        places.indices()[3 * node + c] = static_cast<int>(this->Unknowns.size());
        this->Unknowns.push_back(3 * node + c);
      }
    }
    this->Lower.selfadjointView<Eigen::Lower>() =
        lowerTriangle.selfadjointView<Eigen::Lower>().twistedBy(places);
  }

  // Whether the solution of the known load is the truth, as all other loads see it.
  bool IsSolvedBy(const Eigen::MatrixXd& energy) const
  {
    constexpr double Tolerance = 1e-6; // far above the rounding of a usable matrix
    const Eigen::VectorXd exact = this->Loads->transpose() * this->Truth;
    const Eigen::VectorXd largest = this->Loads->transpose().cwiseAbs() * this->Truth;
    const Eigen::VectorXd off = energy.col(0).tail(exact.size()) - exact;
    const double own = this->Known.dot(this->Truth);
    return (off.array().abs() <= Tolerance * largest.array()).all() &&
           std::abs(energy(0, 0) - own) <= Tolerance * own;
  }

  const LoadMatrix* Loads;
  StiffnessMatrix Lower;
  Eigen::VectorXd Truth;
  Eigen::VectorXd Known;
  std::vector<int> Unknowns; // the row of the loads of each equation
};

// What a part of the order leaves behind.
struct PartPlan
{
  int First; // equations
  int Count;
  std::vector<int> Boundary; // equations of later parts that it changes, ascending
  Eigen::Index Loads = 1;    // up to the last one that is not zero here or before
  std::int64_t Work = 0;     // multiplications

  Eigen::Index Place(int equation) const
  {
    const auto found = std::lower_bound(this->Boundary.begin(), this->Boundary.end(), equation);
    return equation < this->First + this->Count ? equation - this->First
                                                : this->Count + (found - this->Boundary.begin());
  }
};

std::vector<PartPlan> Plan(const OrderedEquations& equations, const NestedDissection& order)
{
  std::vector<PartPlan> plans;
  for (const NestedDissection::Part& part : order.Parts())
  {
    PartPlan plan{3 * part.First, 3 * part.Count, {}};
    const int end = plan.First + plan.Count;
    std::vector<int> touched;
    for (int equation = plan.First; equation < end; ++equation)
    {
      for (StiffnessMatrix::InnerIterator entry(equations.Lower, equation); entry; ++entry)
      {
        touched.push_back(static_cast<int>(entry.row()));
      }
      const int unknown = equations.Unknowns[static_cast<std::size_t>(equation)];
      for (LoadMatrix::InnerIterator entry(*equations.Loads, unknown); entry; ++entry)
      {
        plan.Loads = std::max(plan.Loads, entry.col() + 2);
      }
    }
    for (const int before : part.Before)
    {
      if (before != NestedDissection::None)
      {
        const PartPlan& earlier = plans[static_cast<std::size_t>(before)];
        touched.insert(touched.end(), earlier.Boundary.begin(), earlier.Boundary.end());
        plan.Loads = std::max(plan.Loads, earlier.Loads);
      }
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    plan.Boundary.assign(std::lower_bound(touched.begin(), touched.end(), end), touched.end());
    const auto own = static_cast<std::int64_t>(plan.Count);
    const auto rest = static_cast<std::int64_t>(plan.Boundary.size());
    const auto loads = static_cast<std::int64_t>(plan.Loads);
    plan.Work = own * (own * own / 6 + own * rest / 2 + rest * rest / 2 +
                       loads * (own / 2 + rest + loads / 2));
    plans.push_back(std::move(plan));
  }
  return plans;
}

class Condensation
{
public:
  Condensation(const OrderedEquations& equations, const NestedDissection& order)
      : Equations(equations), Parts(order.Parts()), Plans(Plan(equations, order))
  {
    for (const PartPlan& plan : this->Plans)
    {
      this->Whole += plan.Work;
    }
  }

  // Eliminates all. Returns the reason of a failure, or nothing.
  const char* Run(const KernelProgress& progress, Eigen::MatrixXd& energy)
  {
    const SingleBlasThread single;
    const auto report = [&]
    {
      if (this->Reason == nullptr && progress &&
          !progress(static_cast<double>(this->Done) / static_cast<double>(this->Whole)))
      {
        this->Stop("Cancelled.");
      }
      return this->Reason == nullptr;
    };
    const std::size_t last = this->Parts.size() - 1;
    Eigen::MatrixXd second = Eigen::MatrixXd::Zero(energy.rows(), energy.cols());
    std::vector<DenseFront> halves;
    const int one = this->Parts[last].Before[0];
    const int other = this->Parts[last].Before[1];
    if (other != NestedDissection::None)
    {
      // Two threads on any number of processors: the sums have the same order everywhere.
      auto aside = std::async(std::launch::async,
                              [this, other, &second]
                              {
                                return this->Subtree(static_cast<std::size_t>(other), second,
                                                     [this] { return this->Reason == nullptr; });
                              });
      halves.push_back(this->Subtree(static_cast<std::size_t>(one), energy, report));
      while (aside.wait_for(std::chrono::milliseconds(100)) != std::future_status::ready)
      {
        (void)report();
      }
      halves.push_back(aside.get());
    }
    (void)this->Eliminated(last, std::move(halves), energy, report);
    energy += second;
    return this->Reason;
  }

private:
  using Watch = std::function<bool()>;

  void Stop(const char* reason)
  {
    const char* none = nullptr;
    this->Reason.compare_exchange_strong(none, reason);
  }

  DenseFront Subtree(std::size_t part, Eigen::MatrixXd& energy, const Watch& goesOn)
  {
    std::vector<DenseFront> before;
    for (const int earlier : this->Parts[part].Before)
    {
      if (earlier != NestedDissection::None)
      {
        before.push_back(this->Subtree(static_cast<std::size_t>(earlier), energy, goesOn));
      }
    }
    return this->Eliminated(part, std::move(before), energy, goesOn);
  }

  // What remains of a part and those before it.
  DenseFront Eliminated(std::size_t part, std::vector<DenseFront> before, Eigen::MatrixXd& energy,
                        const Watch& goesOn)
  {
    if (this->Reason != nullptr)
    {
      return {0, 0, 0};
    }
    const PartPlan& plan = this->Plans[part];
    DenseFront front = this->Assembled(plan);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      std::vector<Eigen::Index> places;
      for (const int equation :
           this->Plans[static_cast<std::size_t>(this->Parts[part].Before[i])].Boundary)
      {
        places.push_back(plan.Place(equation));
      }
      front.Add(before[i], places);
      before[i] = DenseFront(0, 0, 0);
    }
    if (!front.Eliminate(goesOn, energy))
    {
      this->Stop(NotDefinite);
    }
    this->Done += plan.Work;
    return front;
  }

  DenseFront Assembled(const PartPlan& plan) const
  {
    DenseFront front(plan.Count, static_cast<Eigen::Index>(plan.Boundary.size()), plan.Loads);
    for (int own = 0; own < plan.Count; ++own)
    {
      const int equation = plan.First + own;
      for (StiffnessMatrix::InnerIterator entry(this->Equations.Lower, equation); entry; ++entry)
      {
        front.Stiffness(plan.Place(static_cast<int>(entry.row())), own) = entry.value();
      }
      const int unknown = this->Equations.Unknowns[static_cast<std::size_t>(equation)];
      front.Load(own, 0) = this->Equations.Known[unknown];
      for (LoadMatrix::InnerIterator entry(*this->Equations.Loads, unknown); entry; ++entry)
      {
        front.Load(own, entry.col() + 1) = entry.value();
      }
    }
    return front;
  }

  const OrderedEquations& Equations;
  const std::vector<NestedDissection::Part>& Parts;
  std::vector<PartPlan> Plans;
  std::int64_t Whole = 0;
  std::atomic<std::int64_t> Done{0};
  std::atomic<const char*> Reason{nullptr};
};
} // namespace

Status CondenseStiffness(const StiffnessMatrix& lowerTriangle, const NestedDissection& order,
                         const LoadMatrix& loads, const KernelProgress& progress,
                         Eigen::MatrixXd& compliance)
{
  try
  {
    const OrderedEquations equations(lowerTriangle, order, loads);
    const Eigen::Index count = loads.cols();
    Eigen::MatrixXd energy = Eigen::MatrixXd::Zero(count + 1, count + 1);
    if (const char* reason = Condensation(equations, order).Run(progress, energy))
    {
      return Status::Failure(reason);
    }
    if (!equations.IsSolvedBy(energy))
    {
      return Status::Failure(NotDefinite);
    }
    compliance = energy.bottomRightCorner(count, count).selfadjointView<Eigen::Lower>();
  }
  catch (const std::bad_alloc&)
  {
    return Status::Failure("There is not enough memory for the equations of elasticity.");
  }
  return Status::Success();
}
} // namespace palpate
