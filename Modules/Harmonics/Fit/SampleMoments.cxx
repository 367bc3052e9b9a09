#include "SampleMoments.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
std::size_t PairCount(int degree)
{
  return 2 * static_cast<std::size_t>(moments::MomentCount(degree));
}
} // namespace

SampleMoments::SampleMoments(std::shared_ptr<const MomentTables> tables,
                             const moments::Kernel& kernel)
    : Tables(std::move(tables)), Kernel(&kernel)
{
  const int degree = this->Tables->Degree();
  this->Scratch.resize(static_cast<std::size_t>(moments::ScratchSize(2 * degree, degree)));
  this->GramSums.resize(PairCount(2 * degree));
  this->RightSums.resize(PairCount(degree));
  this->LaneSums.resize((this->GramSums.size() + this->RightSums.size()) *
                        static_cast<std::size_t>(kernel.Lanes));
}

void SampleMoments::Clear() noexcept
{
  std::fill(this->GramSums.begin(), this->GramSums.end(), 0.0);
  std::fill(this->RightSums.begin(), this->RightSums.end(), 0.0);
}

void SampleMoments::Add(const SampleView& samples) noexcept
{
  const int degree = this->Tables->Degree();
  const int lanes = this->Kernel->Lanes;
  std::fill(this->LaneSums.begin(), this->LaneSums.end(), 0.0);
  double* right = this->LaneSums.data() + this->GramSums.size() * static_cast<std::size_t>(lanes);
  this->Kernel->Accumulate(this->Tables->FamilyRecurrence(), 2 * degree, degree, samples,
                           this->Scratch.data(), this->LaneSums.data(), right);
  const double* lane = this->LaneSums.data();
  for (CacheLineVector<double>* sums : {&this->GramSums, &this->RightSums})
  {
    for (double& sum : *sums)
    {
      for (int i = 0; i < lanes; ++i)
      {
        sum += *lane++;
      }
    }
  }
}
} // namespace palpate
