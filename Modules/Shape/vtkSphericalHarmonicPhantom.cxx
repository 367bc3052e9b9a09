#include "vtkSphericalHarmonicPhantom.h"

#include "ProstateLikeModel.h"

#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkSphericalHarmonicPhantom);

vtkSphericalHarmonicPhantom::vtkSphericalHarmonicPhantom()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

void vtkSphericalHarmonicPhantom::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Dimensions: " << this->Dimensions[0] << " " << this->Dimensions[1] << " "
     << this->Dimensions[2] << "\n";
  os << indent << "Spacing: " << this->Spacing[0] << " " << this->Spacing[1] << " "
     << this->Spacing[2] << "\n";
  os << indent << "OriginWorld: " << this->OriginWorld[0] << " " << this->OriginWorld[1] << " "
     << this->OriginWorld[2] << "\n";
  os << indent << "Degree: " << this->Degree << "\n";
  os << indent << "ShapeSeed: " << this->ShapeSeed << "\n";
  os << indent << "HasModel: " << this->HasModel << "\n";
  os << indent << "NoiseDeviation: " << this->Appearance.NoiseDeviation << "\n";
  os << indent << "BiasAmplitude: " << this->Appearance.BiasAmplitude << "\n";
}

palpate::PhantomGrid vtkSphericalHarmonicPhantom::GetGrid() const
{
  palpate::PhantomGrid grid;
  std::copy_n(this->Dimensions, 3, grid.Size.begin());
  grid.Spacing = palpate::Vector3(this->Spacing);
  grid.OriginWorld = palpate::Vector3(this->OriginWorld);
  grid.Direction =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(this->DirectionMatrix);
  return grid;
}

void vtkSphericalHarmonicPhantom::CenterGridOn(double x, double y, double z)
{
  const palpate::PhantomGrid grid = this->GetGrid();
  const palpate::Vector3 centerIndex(0.5 * (grid.Size[0] - 1), 0.5 * (grid.Size[1] - 1),
                                     0.5 * (grid.Size[2] - 1));
  const palpate::Vector3 origin =
      palpate::Vector3(x, y, z) - (grid.PointWorld(centerIndex) - grid.OriginWorld);
  this->SetOriginWorld(origin.x(), origin.y(), origin.z());
}

void vtkSphericalHarmonicPhantom::SetModel(const palpate::SphericalHarmonicModel& model)
{
  this->Model = model;
  this->HasModel = true;
  this->Modified();
}

void vtkSphericalHarmonicPhantom::ClearModel()
{
  if (this->HasModel)
  {
    this->HasModel = false;
    this->Modified();
  }
}

palpate::SphericalHarmonicModel vtkSphericalHarmonicPhantom::GetModel() const
{
  if (this->HasModel)
  {
    return this->Model;
  }
  const palpate::PhantomGrid grid = this->GetGrid();
  const palpate::Vector3 centerIndex(0.5 * (grid.Size[0] - 1), 0.5 * (grid.Size[1] - 1),
                                     0.5 * (grid.Size[2] - 1));
  return palpate::MakeProstateLikeModel(this->Degree, this->ShapeSeed,
                                        grid.PointWorld(centerIndex));
}

void vtkSphericalHarmonicPhantom::SetAppearance(const palpate::PhantomAppearance& appearance)
{
  this->Appearance = appearance;
  this->Modified();
}

void vtkSphericalHarmonicPhantom::SetNoiseDeviation(double deviation)
{
  this->Appearance.NoiseDeviation = deviation;
  this->Modified();
}

void vtkSphericalHarmonicPhantom::SetBiasAmplitude(double amplitude)
{
  this->Appearance.BiasAmplitude = amplitude;
  this->Modified();
}

void vtkSphericalHarmonicPhantom::SetAppearanceSeed(unsigned int seed)
{
  this->Appearance.Seed = seed;
  this->Modified();
}

int vtkSphericalHarmonicPhantom::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

bool vtkSphericalHarmonicPhantom::SettingsAreUsable()
{
  const palpate::PhantomGrid grid = this->GetGrid();
  const palpate::PhantomAppearance& look = this->Appearance;
  // Written so that NaN fails.
  if (!(grid.Spacing.minCoeff() > 0.0) || !grid.Spacing.allFinite() ||
      *std::min_element(grid.Size.begin(), grid.Size.end()) < 1 || !grid.OriginWorld.allFinite())
  {
    vtkErrorMacro("The phantom's grid needs at least one voxel and a positive spacing along each "
                  "axis.");
    return false;
  }
  if (!grid.Direction.isUnitary(1e-6))
  {
    vtkErrorMacro("The columns of the phantom's direction matrix must be orthonormal.");
    return false;
  }
  if (!(look.NoiseDeviation >= 0.0) || !(look.BiasAmplitude >= 0.0 && look.BiasAmplitude < 1.0) ||
      !(look.InnerZoneFraction >= 0.0 && look.InnerZoneFraction <= 1.0) ||
      !(look.CapsuleThickness >= 0.0) || look.Subdivision < 1)
  {
    vtkErrorMacro(
        "The phantom's noise and capsule must not be negative, its bias must be in [0, 1), "
        "its inner zone in [0, 1], and its subdivision at least 1.");
    return false;
  }
  return true;
}

int vtkSphericalHarmonicPhantom::RequestInformation(vtkInformation*, vtkInformationVector**,
                                                    vtkInformationVector* outputs)
{
  const int extent[6] = {0, this->Dimensions[0] - 1, 0, this->Dimensions[1] - 1,
                         0, this->Dimensions[2] - 1};
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(port);
    info->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), extent, 6);
    info->Set(vtkDataObject::SPACING(), this->Spacing, 3);
    info->Set(vtkDataObject::ORIGIN(), this->OriginWorld, 3);
    info->Set(vtkDataObject::DIRECTION(), this->DirectionMatrix, 9);
    vtkDataObject::SetPointDataActiveScalarInfo(info, port == 0 ? VTK_FLOAT : VTK_UNSIGNED_CHAR, 1);
  }
  return 1;
}

int vtkSphericalHarmonicPhantom::RequestData(vtkInformation*, vtkInformationVector**,
                                             vtkInformationVector* outputs)
{
  if (!this->SettingsAreUsable())
  {
    return 0;
  }
  const palpate::PhantomSampler sampler(this->GetModel(), this->GetGrid(), this->Appearance);
  vtkImageData* images[2];
  for (int port = 0; port < 2; ++port)
  {
    images[port] = vtkImageData::GetData(outputs, port);
    images[port]->SetDimensions(this->Dimensions);
    images[port]->SetSpacing(this->Spacing);
    images[port]->SetOrigin(this->OriginWorld);
    images[port]->SetDirectionMatrix(this->DirectionMatrix);
    images[port]->AllocateScalars(port == 0 ? VTK_FLOAT : VTK_UNSIGNED_CHAR, 1);
    images[port]->GetPointData()->GetScalars()->SetName(port == 0 ? "Intensity" : "Label");
  }
  auto* intensities = static_cast<float*>(images[0]->GetScalarPointer());
  auto* labels = static_cast<unsigned char*>(images[1]->GetScalarPointer());
  const vtkIdType rowLength = this->Dimensions[0];
  const vtkIdType rowsPerSlice = this->Dimensions[1];
  // Slab by slab, so that the calling thread can report progress and check for an abort.
  for (int k = 0; k < this->Dimensions[2] && !this->AbortExecute; ++k)
  {
    vtkSMPTools::For(0, rowsPerSlice,
                     [&](vtkIdType first, vtkIdType last)
                     {
                       for (vtkIdType j = first; j < last; ++j)
                       {
                         const vtkIdType start = (k * rowsPerSlice + j) * rowLength;
                         sampler.SampleRow(static_cast<int>(j), k, intensities + start,
                                           labels + start);
                       }
                     });
    this->UpdateProgress((k + 1.0) / this->Dimensions[2]);
  }
  if (this->AbortExecute)
  {
    images[0]->Initialize();
    images[1]->Initialize();
  }
  return 1;
}
