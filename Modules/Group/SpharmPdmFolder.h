#pragma once

#include "OrganModel.h"
#include "PalpateGroupModule.h"

#include <filesystem>
#include <string>

namespace palpate
{
/// The three poses of a case that SPHARM-PDM writes.
struct SpharmPdmCase
{
  std::string Name;     ///< of files, plain
  OrganModel Patient;   ///< in the patient's frame
  OrganModel Ellipsoid; ///< in its principal axes
  OrganModel Group;     ///< as the group is aligned
};

/// Writes a case under the names that scripts around SPHARM-PDM look for, into `folder`:
/// Step2_GenParaMesh/NAME_pp_{para,surf}.vtk and, in Step3_ParaToSPHARMMesh,
/// NAME_pp_surf{_SPHARM,_SPHARM_ellalign}
/// {.vtk,.coef}, _SPHARM_procalign.vtk, _para.vtk, _para{Phi,PhiHalf,Theta,Mix}.txt,
/// _MedialAxisScalars.csv, _SPHARMMedialAxis.vtk, _SPHARMMedialMesh.vtk and
/// _medialMesh{Radius,Area,PartialRadius,PartialArea}.txt (LatitudeAxis of the patient's pose,
/// along its long axis, 100 circles of 100 points). VTK files are legacy ASCII, single precision,
/// RAS, mm; 4,002 points of one icosahedron, so that equal indices correspond. `_pp_surf` is the
/// model, not the voxels' faces. Throws InputError.
PALPATEGROUP_EXPORT void WriteSpharmPdmCase(const SpharmPdmCase& one,
                                            const std::filesystem::path& folder);
} // namespace palpate
