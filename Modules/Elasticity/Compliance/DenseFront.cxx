#include "DenseFront.h"

#include "MatrixBlock.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace palpate
{
DenseFront::DenseFront(Eigen::Index eliminated, Eigen::Index remaining, Eigen::Index loads)
    : Pivots(Eigen::MatrixXd::Zero(eliminated + remaining, eliminated)),
      PivotLoads(Eigen::MatrixXd::Zero(eliminated, loads)),
      Rest(Eigen::MatrixXd::Zero(remaining, remaining)),
      RestLoads(Eigen::MatrixXd::Zero(remaining, loads))
{
}

void DenseFront::Add(const DenseFront& other, const std::vector<Eigen::Index>& places)
{
  const auto count = static_cast<Eigen::Index>(places.size());
  const Eigen::Index own = this->Pivots.cols();
  const auto pivots = static_cast<Eigen::Index>(
      std::lower_bound(places.begin(), places.end(), own) - places.begin());
  const Eigen::Index* const at = places.data();
  for (Eigen::Index column = 0; column < count; ++column)
  {
    double* const to = column < pivots ? this->Pivots.col(at[column]).data()
                                       : this->Rest.col(at[column] - own).data() - own;
    for (Eigen::Index row = column; row < count; ++row)
    {
      to[at[row]] += other.Rest(row, column);
    }
  }
  for (Eigen::Index load = 0; load < other.RestLoads.cols(); ++load)
  {
    for (Eigen::Index row = 0; row < pivots; ++row)
    {
      this->PivotLoads(at[row], load) += other.RestLoads(row, load);
    }
    for (Eigen::Index row = pivots; row < count; ++row)
    {
      this->RestLoads(at[row] - own, load) += other.RestLoads(row, load);
    }
  }
}

bool DenseFront::Eliminate(const std::function<bool()>& goesOn, Eigen::MatrixXd& energy)
{
  // As many at a time as BLAS is quick with.
  constexpr Eigen::Index Few = 64;
  constexpr Eigen::Index Many = 256;
  const Eigen::Index count = this->Pivots.cols();
  for (Eigen::Index first = 0; first < count; first += Few)
  {
    if (!goesOn() || !this->TakePivots(first, std::min(Few, count - first)))
    {
      return false;
    }
  }
  for (Eigen::Index first = 0; first < count; first += Many)
  {
    if (!goesOn())
    {
      return false;
    }
    this->ChangeRest(first, std::min(Many, count - first));
  }
  const Eigen::Index loads = this->PivotLoads.cols();
  MatrixBlock(energy, 0, 0, loads, loads)
      .AddProducts(MatrixBlock(this->PivotLoads, 0, 0, count, loads));
  this->Pivots.resize(0, 0);
  this->PivotLoads.resize(0, 0);
  return true;
}

// Unknowns that follow each other. What is before them is eliminated.
bool DenseFront::TakePivots(Eigen::Index first, Eigen::Index count)
{
  Eigen::Ref<Eigen::MatrixXd> pivot = this->Pivots.block(first, first, count, count);
  const Eigen::LLT<Eigen::Ref<Eigen::MatrixXd>> factored(pivot);
  if (factored.info() != Eigen::Success)
  {
    return false;
  }
  const Eigen::Index next = first + count;
  const Eigen::Index after = this->Pivots.cols() - next;
  const Eigen::Index loads = this->PivotLoads.cols();
  const MatrixBlock lower(this->Pivots, first, first, count, count);
  MatrixBlock(this->Pivots, next, first, this->Pivots.rows() - next, count).SolveFromRight(lower);
  MatrixBlock load(this->PivotLoads, first, 0, count, loads);
  load.Solve(lower);
  const MatrixBlock other(this->Pivots, next, first, after, count);
  const MatrixBlock below(this->Pivots, next + after, first, this->Rest.rows(), count);
  MatrixBlock(this->Pivots, next, next, after, after).SubtractSquare(other);
  MatrixBlock(this->Pivots, next + after, next, this->Rest.rows(), after)
      .SubtractOuterProduct(below, other);
  MatrixBlock(this->PivotLoads, next, 0, after, loads).SubtractProduct(other, load);
  return true;
}

// By eliminated unknowns that follow each other.
void DenseFront::ChangeRest(Eigen::Index first, Eigen::Index count)
{
  const Eigen::Index remaining = this->Rest.rows();
  const Eigen::Index loads = this->PivotLoads.cols();
  const MatrixBlock below(this->Pivots, this->Pivots.cols(), first, remaining, count);
  MatrixBlock(this->Rest, 0, 0, remaining, remaining).SubtractSquare(below);
  MatrixBlock(this->RestLoads, 0, 0, remaining, loads)
      .SubtractProduct(below, MatrixBlock(this->PivotLoads, first, 0, count, loads));
}
} // namespace palpate
