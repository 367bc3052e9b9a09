#pragma once

#include "EigenPeers.h"
#include "ItkInterpolators.h"

namespace palpate::bench
{
// Exports of the two libraries of alternatives (CMakeLists.txt sets the names by definitions).
const EigenPeers& PortableEigen();
const EigenPeers& Avx2Eigen();
std::unique_ptr<ItkInterpolators> MakePortableItk(const FieldGrid& grid,
                                                  const std::vector<std::int16_t>& samples);
std::unique_ptr<ItkInterpolators> MakeAvx2Itk(const FieldGrid& grid,
                                              const std::vector<std::int16_t>& samples);
} // namespace palpate::bench
