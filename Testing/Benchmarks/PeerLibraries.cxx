#include "PeerLibraries.h"

#include "InstructionSet.h"

namespace palpate::bench
{
namespace
{
bool HasAvx2()
{
  return FastestInstructionSet() == InstructionSet::Avx2;
}
} // namespace

const EigenPeers& FastestEigenPeers()
{
  return HasAvx2() ? Avx2Eigen() : PortableEigen();
}

const EigenPeers& PortableEigenPeers()
{
  return PortableEigen();
}

std::unique_ptr<ItkInterpolators> MakeItkInterpolators(const FieldGrid& grid,
                                                       const std::vector<std::int16_t>& samples)
{
  return HasAvx2() ? MakeAvx2Itk(grid, samples) : MakePortableItk(grid, samples);
}
} // namespace palpate::bench
