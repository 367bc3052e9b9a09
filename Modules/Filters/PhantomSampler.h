#pragma once

#include "PalpateFiltersModule.h"
#include "PhantomNodule.h"
#include "RadialModel.h"
#include "Vector3.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>

namespace palpate
{
/// A voxel grid in patient LPS: the centre of voxel (i, j, k) is
/// OriginWorld + Direction * (Spacing .* (i, j, k)), mm.
struct PhantomGrid
{
  std::array<int, 3> Size{{160, 160, 24}};
  Vector3 Spacing{0.5, 0.5, 3.0};
  Vector3 OriginWorld{-39.75, -39.75, -34.5};              ///< centred on the world's origin
  Eigen::Matrix3d Direction = Eigen::Matrix3d::Identity(); ///< orthonormal columns

  Vector3 PointWorld(const Vector3& index) const
  {
    return this->OriginWorld + this->Direction * this->Spacing.cwiseProduct(index);
  }

  /// Moves the grid so that its centre is at this point (mm, LPS).
  void CenterOn(const Vector3& centerWorld)
  {
    const Vector3 centerIndex(0.5 * (this->Size[0] - 1), 0.5 * (this->Size[1] - 1),
                              0.5 * (this->Size[2] - 1));
    this->OriginWorld = centerWorld - (this->PointWorld(centerIndex) - this->OriginWorld);
  }
};

/// Appearance of a phantom. Intensities are in the image's own arbitrary unit, lengths in mm.
struct PhantomAppearance
{
  enum class Noise
  {
    Gaussian, ///< added
    Rician    ///< magnitude of a complex signal with noise in both parts, as in MR
  };

  double Background = 90.0;
  double Body = 220.0;
  double Capsule = 40.0;
  double InnerZone = 140.0;
  double CapsuleThickness = 1.0;       ///< mm, measured inwards along the radius
  double InnerZoneFraction = 0.6;      ///< of the body's radius; 0 for none
  std::optional<PhantomNodule> Nodule; ///< inside the body (PhantomNodule::Place)
  double NoduleIntensity = 100.0;      ///< darker than both zones, as a lesion in T2
  int Subdivision = 4;                 ///< sample points per voxel along each axis
  double BiasAmplitude = 0.0;          ///< the bias field lies within 1 +- this; in [0, 1)
  double NoiseDeviation = 0.0; ///< standard deviation of the noise, before taking the magnitude
  Noise NoiseKind = Noise::Rician;
  std::uint64_t Seed = 1; ///< of noise and bias field
};

/// Fills the rows of a phantom's mask and MR-like volume. Rows can be filled independently, in any
/// order and by any thread, with the same result. Grid and appearance must be sensible: voxels of
/// positive size, no negative noise.
///
/// The mask holds the voxels whose centre lies inside the model. The intensity is the mean over
/// Subdivision^3 points of background, capsule, inner zone, body or nodule, times the bias field,
/// with noise. Voxels of a single tissue are not subdivided: a bound on the gradient of
/// |x| - R(x / |x|), from the addition theorem of the harmonics, identifies them.
class PALPATEFILTERS_EXPORT PhantomSampler
{
public:
  PhantomSampler(const RadialModel& model, const PhantomGrid& grid,
                 const PhantomAppearance& appearance);

  /// Row (j, k) of the grid: Size[0] values each.
  void SampleRow(int j, int k, float* intensities, unsigned char* mask) const;
  /// The same row of the nodule's mask: 1 where a voxel's centre lies in it.
  void SampleNoduleRow(int j, int k, unsigned char* mask) const;

  double BiasAt(const Vector3& index) const;

  /// An upper bound of the model's radius (mm), from its power spectrum.
  static double RadiusBound(const RadialModel& model);

private:
  /// Of the point at `offset` from the model's centre, `distance` from it, where R is `radius`.
  double TissueAt(const Vector3& offset, double distance, double radius) const;
  /// Intensity without bias and noise of the voxel whose centre is at `offset` from the model's.
  double VoxelMean(const Vector3& offset, double distance, double radius) const;
  double SubdividedMean(const Vector3& offset) const;
  /// Whether the nodule's surface may pass through the voxel.
  bool IsCutByNodule(const Vector3& offset) const;
  /// Largest change of |x| - s R from its value at `distance` anywhere in a voxel centred there.
  double VariationWithin(double distance) const;
  void AddNoise(int j, int k, float* intensities) const;

  RadialModel Model;
  PhantomGrid Grid;
  PhantomAppearance Appearance;
  Eigen::Matrix3d StepWorld; ///< columns: the step of one voxel along each axis, mm
  double HalfDiagonal;       ///< of a voxel, mm
  double LargestRadius;      ///< upper bound of R, mm
  double SlopeBound;         ///< upper bound of |grad R| on the unit sphere, mm/rad
  std::array<double, 9> BiasTerms{};
};

struct PhantomImages
{
  vtkSmartPointer<vtkImageData> Volume; ///< float
  vtkSmartPointer<vtkImageData> Mask;   ///< unsigned char, 1 inside
  vtkSmartPointer<vtkImageData> Nodule; ///< unsigned char, 1 in the nodule; null if there is none
};

/// An MR-like volume and the mask of a body whose coefficients are known, on any grid, including
/// oblique ones, by PhantomSampler. The result does not depend on the number of threads. `progress`
/// is called with the part that is done, by the calling thread, and may throw to end the work.
PALPATEFILTERS_EXPORT PhantomImages MakePhantom(
    const RadialModel& model, const PhantomGrid& grid, const PhantomAppearance& appearance = {},
    const std::function<void(double)>& progress = [](double) {});
} // namespace palpate
