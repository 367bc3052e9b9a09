#include "SparseCholesky.h"

#include <dmumps_c.h>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <string>
#include <vector>

// Of OpenBLAS, where that is the BLAS in use.
extern "C" __attribute__((weak)) int openblas_get_num_threads();
extern "C" __attribute__((weak)) void openblas_set_num_threads(int count);

namespace palpate
{
namespace
{
// With several threads of OpenBLAS a result would depend on the number of processors, and its
// threads, which wait for each other without sleeping, would take minutes on a busy machine.
class SingleBlasThread
{
public:
  SingleBlasThread()
  {
    if (openblas_get_num_threads != nullptr && openblas_set_num_threads != nullptr)
    {
      this->Before = openblas_get_num_threads();
      openblas_set_num_threads(1);
    }
  }
  ~SingleBlasThread()
  {
    if (this->Before > 0)
    {
      openblas_set_num_threads(this->Before);
    }
  }
  SingleBlasThread(const SingleBlasThread&) = delete;
  SingleBlasThread& operator=(const SingleBlasThread&) = delete;

private:
  int Before = 0;
};
} // namespace

// MUMPS numbers from 1 and keeps the addresses of the matrix.
struct SparseCholesky::Instance
{
  DMUMPS_STRUC_C Id{};
  std::vector<MUMPS_INT> Rows;
  std::vector<MUMPS_INT> Columns;
  std::vector<double> Values;

  Instance()
  {
    constexpr MUMPS_INT WithoutMpi = -987654;
    this->Id.par = 1;
    this->Id.sym = 1; // positive definite
    this->Id.comm_fortran = WithoutMpi;
    (void)this->Do(-1);
    std::fill_n(this->Id.icntl, 3, -1); // prints nothing
    this->Id.icntl[3] = 0;
    // Ordering by PORD: Scotch's threads, a quarter faster in all, find another order each time.
    this->Id.icntl[6] = 4;
    this->Id.icntl[13] = 30; // spare memory, %
  }
  ~Instance() { (void)this->Do(-2); }
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  Status Do(MUMPS_INT job)
  {
    // MUMPS keeps module variables: two threads in it at once end the program.
    static std::mutex solving;
    const std::lock_guard<std::mutex> alone(solving);
    const SingleBlasThread single;
    this->Id.job = job;
    dmumps_c(&this->Id);
    const MUMPS_INT code = this->Id.infog[0];
    return code >= 0 ? Status::Success()
                     : Status::Failure("The equations of elasticity could not be solved (MUMPS " +
                                       std::to_string(code) + ").");
  }
};

SparseCholesky::SparseCholesky() : Solver(std::make_unique<Instance>()) {}
SparseCholesky::~SparseCholesky() = default;

Status SparseCholesky::Factor(const StiffnessMatrix& lowerTriangle, const KernelProgress& progress)
{
  // Parts of the time, measured with the defaults of OrganSoftening.
  constexpr double Copied = 0.05;
  constexpr double Analysed = 0.3;
  constexpr double Factored = 0.95;
  const auto next = [&](double fraction, const Status& before)
  {
    return before.IsOk() && progress && !progress(fraction) ? Status::Failure("Cancelled.")
                                                            : before;
  };
  Instance& solver = *this->Solver;
  const auto count = static_cast<std::size_t>(lowerTriangle.nonZeros());
  solver.Rows.clear();
  solver.Columns.clear();
  solver.Values.clear();
  solver.Rows.reserve(count);
  solver.Columns.reserve(count);
  solver.Values.reserve(count);
  for (Eigen::Index column = 0; column < lowerTriangle.outerSize(); ++column)
  {
    for (StiffnessMatrix::InnerIterator entry(lowerTriangle, column); entry; ++entry)
    {
      solver.Rows.push_back(static_cast<MUMPS_INT>(entry.row()) + 1);
      solver.Columns.push_back(static_cast<MUMPS_INT>(column) + 1);
      solver.Values.push_back(entry.value());
    }
  }
  solver.Id.n = static_cast<MUMPS_INT>(lowerTriangle.rows());
  solver.Id.nz = static_cast<MUMPS_INT>(count);
  solver.Id.irn = solver.Rows.data();
  solver.Id.jcn = solver.Columns.data();
  solver.Id.a = solver.Values.data();
  Status factored = next(Copied, Status::Success());
  factored = factored.IsOk() ? next(Analysed, solver.Do(1)) : factored;
  factored = factored.IsOk() ? next(Factored, solver.Do(2)) : factored;
  if (!factored.IsOk())
  {
    return factored;
  }
  // Without pivots a singular matrix shows by its solutions.
  constexpr double Tolerance = 1e-6; // far above the rounding of a usable matrix
  const Eigen::VectorXd truth = Eigen::VectorXd::LinSpaced(lowerTriangle.rows(), 1.0, 2.0);
  Eigen::MatrixXd solution = lowerTriangle.selfadjointView<Eigen::Lower>() * truth;
  const Status solved = this->Solve(solution);
  const bool isExact = (solution.col(0) - truth).cwiseAbs().maxCoeff() <= Tolerance;
  return !solved.IsOk() || isExact
             ? solved
             : Status::Failure("The equations of elasticity have no definite solution.");
}

Status SparseCholesky::Solve(Eigen::MatrixXd& columns)
{
  DMUMPS_STRUC_C& id = this->Solver->Id;
  id.nrhs = static_cast<MUMPS_INT>(columns.cols());
  id.lrhs = static_cast<MUMPS_INT>(columns.rows());
  id.rhs = columns.data();
  id.icntl[26] = 64; // right sides at a time
  return this->Solver->Do(3);
}
} // namespace palpate
