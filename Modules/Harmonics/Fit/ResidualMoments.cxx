#include "ResidualMoments.h"

#include <algorithm>
#include <utility>

namespace palpate
{
ResidualMoments::ResidualMoments(std::shared_ptr<const MomentTables> tables,
                                 const moments::Kernel& kernel)
    : Tables(std::move(tables)), Kernel(&kernel)
{
  const int degree = this->Tables->Degree();
  this->Scratch.resize(static_cast<std::size_t>(moments::ScratchSize(degree, degree)));
  this->Pairs.resize(2 * static_cast<std::size_t>(moments::MomentCount(degree)));
  this->LaneSums.resize(this->Pairs.size() * static_cast<std::size_t>(kernel.Lanes));
}

void ResidualMoments::Find(const SampleView& samples, const double* coefficients, double* residuals,
                           double* sums) noexcept
{
  this->Tables->FromHarmonics(coefficients, this->Pairs.data());
  std::fill(this->LaneSums.begin(), this->LaneSums.end(), 0.0);
  this->Kernel->Residuals(this->Tables->FamilyRecurrence(), this->Tables->Degree(), samples,
                          this->Pairs.data(), this->Scratch.data(), residuals,
                          this->LaneSums.data());
  const double* lane = this->LaneSums.data();
  for (double& pair : this->Pairs)
  {
    pair = 0.0;
    for (int i = 0; i < this->Kernel->Lanes; ++i)
    {
      pair += *lane++;
    }
  }
  this->Tables->ToHarmonics(this->Pairs.data(), sums);
}
} // namespace palpate
