#include "SoftwareVersions.h"

#include "vtkVersion.h"

#include <Eigen/Core>

namespace palpate
{
namespace
{
std::string EigenVersion()
{
  return std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
         std::to_string(EIGEN_MINOR_VERSION);
}
} // namespace

std::vector<std::pair<std::string, std::string>> SoftwareVersions()
{
  return {{"Palpate", PALPATE_VERSION},
          {"VTK", vtkVersion::GetVTKVersion()},
          {"ITK", PALPATE_ITK_VERSION},
          {"Eigen", EigenVersion()},
          {"Compiler", PALPATE_COMPILER}};
}
} // namespace palpate
