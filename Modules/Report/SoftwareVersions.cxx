#include "SoftwareVersions.h"

#include "vtkVersion.h"

#include <Eigen/Core>

namespace palpate
{
namespace
{
std::string Dotted(int major, int minor, int patch)
{
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

std::string EigenVersion()
{
#ifdef EIGEN_PATCH_VERSION // since Eigen 5, whose "world" still is 3
  return Dotted(EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, EIGEN_PATCH_VERSION);
#else
  return Dotted(EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION);
#endif
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
