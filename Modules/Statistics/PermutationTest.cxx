#include "PermutationTest.h"

#include "ClusterEnhancement.h"
#include "ProcessorCount.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <thread>

namespace palpate
{
namespace
{
constexpr int BatchSize = 8; // permutations; their products with the residuals fit into a cache
// Orders that differ only within groups give equal statistics up to rounding.
constexpr double Tie = 1.0 - 1e-9;

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

/// What all permutations share, and the observed statistics.
struct PermutedModel
{
  RowMatrix Basis; ///< rows: columns of the term, then of the others but the constant
  Eigen::Index EffectCount;
  double FreeDegrees;
  const LinearOutcomes& Outcomes;
  RowMatrix Residuals; ///< of their factors under the other terms
  Eigen::ArrayXd Totals;
  Eigen::ArrayXd Areas;

  // Of combinations of cases with the residuals at each point. `ofFactors` is for later calls.
  void Multiply(const RowMatrix& combinations, RowMatrix& ofFactors, RowMatrix& products) const
  {
    RowMatrix& first = this->Outcomes.IsFactored() ? ofFactors : products;
    first.noalias() = combinations * this->Residuals;
    if (this->Outcomes.IsFactored())
    {
      products.noalias() = first * this->Outcomes.PerFactor();
    }
  }
};

PermutedModel MakePermutedModel(const EffectSpace& space, const LinearOutcomes& outcomes,
                                const SurfaceGraph& surface)
{
  PermutedModel model{{}, 0, 0.0, outcomes, {}, {}, {}};
  const Eigen::Index others = space.Others.cols() - 1;
  model.EffectCount = space.Effect.cols();
  model.FreeDegrees = static_cast<double>(outcomes.CaseCount() - model.EffectCount - others - 1);
  model.Basis.resize(model.EffectCount + others, outcomes.CaseCount());
  model.Basis << space.Effect.transpose(), space.Others.rightCols(others).transpose();
  const Eigen::MatrixXd& factors = outcomes.Factors();
  model.Residuals = factors - space.Others * (space.Others.transpose() * factors);
  model.Totals = outcomes.SquaredNorms(model.Residuals).array();
  model.Areas = Eigen::Map<const Eigen::ArrayXd>(surface.Areas.data(),
                                                 static_cast<Eigen::Index>(surface.Areas.size()));
  return model;
}

/// Statistics of one order of the cases.
struct OrderStatistics
{
  Eigen::ArrayXd Squares; ///< F of each point
  Eigen::VectorXd Signed; ///< its root, with the effect's sign if the term has one column
  double WholeF = 0.0;

  // `products` of the basis, permuted, with the residuals.
  void Take(const PermutedModel& model, const Eigen::Ref<const RowMatrix>& products)
  {
    const Eigen::Index count = model.EffectCount;
    this->Explained = products.topRows(count).colwise().squaredNorm().transpose().array();
    this->Rest =
        model.Totals - this->Explained -
        products.bottomRows(products.rows() - count).colwise().squaredNorm().transpose().array();
    const double factor = model.FreeDegrees / static_cast<double>(count);
    // A point without any variance has no effect.
    this->Squares =
        (model.Totals > 0.0)
            .select(factor * this->Explained /
                        this->Rest.max(model.Totals * std::numeric_limits<double>::epsilon()),
                    0.0);
    this->Signed = this->Squares.sqrt().matrix();
    if (count == 1)
    {
      this->Signed =
          (products.row(0).transpose().array() < 0.0).select(-this->Signed, this->Signed);
    }
    const double rest = (model.Areas * this->Rest).sum();
    this->WholeF = rest > 0.0 ? factor * (model.Areas * this->Explained).sum() / rest : 0.0;
  }

private:
  Eigen::ArrayXd Explained;
  Eigen::ArrayXd Rest;
};

/// Enhancement of both signs: absolute values.
class SignedEnhancement
{
public:
  explicit SignedEnhancement(const SurfaceGraph& surface) : One(surface.Areas, surface.Edges) {}

  const Eigen::VectorXd& Of(const Eigen::VectorXd& map)
  {
    this->One.Enhance(map, this->Positive);
    if (map.minCoeff() < 0.0)
    {
      this->Opposite = -map;
      this->One.Enhance(this->Opposite, this->Negative);
      this->Positive += this->Negative;
    }
    return this->Positive;
  }

private:
  ClusterEnhancement One;
  Eigen::VectorXd Positive;
  Eigen::VectorXd Negative;
  Eigen::VectorXd Opposite;
};

/// The order of a permutation, from the seed and its number alone.
void Shuffle(std::uint64_t seed, std::size_t number, std::vector<Eigen::Index>& order)
{
  std::seed_seq sequence{seed, seed >> 32U, static_cast<std::uint64_t>(number)};
  std::mt19937_64 engine(sequence);
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  for (std::size_t left = order.size(); left > 1; --left)
  {
    // The bias of a remainder is below 1e-16 here.
    std::swap(order[left - 1], order[engine() % left]);
  }
}

/// What is known of all permutations after a run.
struct PermutationCounts
{
  std::vector<double> LargestF;
  std::vector<double> LargestEnhanced;
  std::vector<double> WholeF;
};

/// One thread's part of the permutations.
class PermutationWorker
{
public:
  PermutationWorker(const PermutedModel& model, const SurfaceGraph& surface,
                    const Eigen::ArrayXd& observed, std::uint64_t seed)
      : Model(model), Least(observed * Tie), Seed(seed), Enhancement(surface),
        Reached(Eigen::ArrayXi::Zero(observed.size())),
        Order(static_cast<std::size_t>(model.Residuals.rows()))
  {
  }

  void Run(std::size_t first, std::size_t count, PermutationCounts& counts)
  {
    const Eigen::Index rows = this->Model.Basis.rows();
    this->Permuted.resize(rows * static_cast<Eigen::Index>(count), this->Model.Basis.cols());
    for (std::size_t k = 0; k < count; ++k)
    {
      Shuffle(this->Seed, first + k, this->Order);
      for (std::size_t row = 0; row < this->Order.size(); ++row)
      {
        this->Permuted.block(static_cast<Eigen::Index>(k) * rows, static_cast<Eigen::Index>(row),
                             rows, 1) = this->Model.Basis.col(this->Order[row]);
      }
    }
    this->Model.Multiply(this->Permuted, this->OfFactors, this->Products);
    for (std::size_t k = 0; k < count; ++k)
    {
      this->Statistics.Take(this->Model,
                            this->Products.middleRows(static_cast<Eigen::Index>(k) * rows, rows));
      this->Reached += (this->Statistics.Squares >= this->Least).cast<int>();
      counts.LargestF[first + k] = this->Statistics.Squares.maxCoeff();
      counts.LargestEnhanced[first + k] = this->Enhancement.Of(this->Statistics.Signed).maxCoeff();
      counts.WholeF[first + k] = this->Statistics.WholeF;
    }
  }
  const Eigen::ArrayXi& Counts() const { return this->Reached; }

private:
  const PermutedModel& Model;
  Eigen::ArrayXd Least;
  std::uint64_t Seed;
  SignedEnhancement Enhancement;
  Eigen::ArrayXi Reached;
  std::vector<Eigen::Index> Order;
  RowMatrix Permuted;
  RowMatrix OfFactors;
  RowMatrix Products;
  OrderStatistics Statistics;
};

/// Shares the batches out to threads; the caller's own reports progress.
class PermutationRun
{
public:
  PermutationRun(std::size_t count, std::vector<PermutationWorker>& workers)
      : Count(count), Workers(workers)
  {
    for (std::vector<double>* values :
         {&this->Counts.LargestF, &this->Counts.LargestEnhanced, &this->Counts.WholeF})
    {
      values->resize(count);
    }
  }

  bool Finish(const KernelProgress& progress)
  {
    std::vector<std::thread> threads;
    for (std::size_t i = 1; i < this->Workers.size(); ++i)
    {
      threads.emplace_back([this, i] { this->Work(this->Workers[i], {}); });
    }
    this->Work(this->Workers[0], progress);
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    return !this->Cancelled;
  }
  const PermutationCounts& Result() const { return this->Counts; }

private:
  void Work(PermutationWorker& worker, const KernelProgress& progress)
  {
    for (std::size_t first = this->Next.fetch_add(BatchSize);
         first < this->Count && !this->Cancelled; first = this->Next.fetch_add(BatchSize))
    {
      worker.Run(first, std::min<std::size_t>(BatchSize, this->Count - first), this->Counts);
      if (progress && !progress(static_cast<double>(first) / static_cast<double>(this->Count)))
      {
        this->Cancelled = true;
      }
    }
  }

  std::size_t Count;
  std::vector<PermutationWorker>& Workers;
  PermutationCounts Counts;
  std::atomic<std::size_t> Next{0};
  std::atomic<bool> Cancelled{false};
};

// Share of the orders, the observed one included, that reach a value.
double ShareOf(double value, const std::vector<double>& ascending)
{
  const auto reached =
      ascending.end() - std::lower_bound(ascending.begin(), ascending.end(), value * Tie);
  return static_cast<double>(reached + 1) / static_cast<double>(ascending.size() + 1);
}

Eigen::VectorXd SharesOf(const Eigen::VectorXd& values, std::vector<double> largest)
{
  std::sort(largest.begin(), largest.end());
  return values.unaryExpr([&](double value) { return ShareOf(value, largest); });
}

unsigned ThreadsOf(const PermutationSettings& settings)
{
  const unsigned wanted = settings.Threads != 0 ? settings.Threads : ProcessorCount();
  const auto batches = static_cast<unsigned>((settings.Count + BatchSize - 1) / BatchSize);
  return std::clamp(wanted, 1U, std::max(batches, 1U));
}
} // namespace

Status TestByPermutation(const EffectSpace& space, const LinearOutcomes& outcomes,
                         const SurfaceGraph& surface, const PermutationSettings& settings,
                         const KernelProgress& progress, PermutationTest& test)
{
  const PermutedModel model = MakePermutedModel(space, outcomes, surface);
  OrderStatistics observed;
  RowMatrix ofFactors;
  RowMatrix products;
  model.Multiply(model.Basis, ofFactors, products);
  observed.Take(model, products);
  std::vector<PermutationWorker> workers;
  for (unsigned i = 0; i < ThreadsOf(settings); ++i)
  {
    workers.emplace_back(model, surface, observed.Squares, settings.Seed);
  }
  PermutationRun run(static_cast<std::size_t>(std::max(settings.Count, 0)), workers);
  if (!run.Finish(progress))
  {
    return Status::Failure("cancelled");
  }
  Eigen::ArrayXi reached = Eigen::ArrayXi::Ones(outcomes.OutcomeCount());
  for (const PermutationWorker& worker : workers)
  {
    reached += worker.Counts();
  }
  test.Statistic = observed.Signed;
  test.P = (reached.cast<double>() / (settings.Count + 1.0)).matrix();
  test.FamilyP = SharesOf(observed.Squares.matrix(), run.Result().LargestF);
  test.EnhancedP =
      SharesOf(SignedEnhancement(surface).Of(observed.Signed), run.Result().LargestEnhanced);
  test.WholeF = observed.WholeF;
  std::vector<double> whole = run.Result().WholeF;
  std::sort(whole.begin(), whole.end());
  test.WholeP = ShareOf(observed.WholeF, whole);
  return Status::Success();
}
} // namespace palpate
