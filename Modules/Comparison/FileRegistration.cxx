#include "FileRegistration.h"

#include "AffineRows.h"
#include "BodyMotion.h"
#include "InputError.h"
#include "KernelWatch.h"
#include "Refusal.h"
#include "StructurePairs.h"
#include "VolumeFile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace palpate
{
namespace
{
constexpr std::size_t EnoughPoints = 40;   // from which on the predicted error is honest
constexpr std::size_t EnoughLandmarks = 8; // from which on exchanged pairs are found
constexpr double SuspiciousWeight = 0.1;

Vector3 MiddleOf(const std::vector<Vector3>& points)
{
  Vector3 middle = Vector3::Zero();
  for (const Vector3& point : points)
  {
    middle += point / static_cast<double>(points.size());
  }
  return middle;
}

// The only structure of a file, or the one that is named.
ComparedBody BodyOf(const std::filesystem::path& path, const std::string& label,
                    const VolumeChoice& images)
{
  const ComparedFile file = ComparedFile::Read(path, images);
  const Segment structure =
      OnlyStructure(file, label, "choose one by --label, of the fixed file by --fixed-label");
  return file.Body(structure, MaskBody::Shape);
}

Vector3 MiddleOf(vtkImageData* image)
{
  Vector3 middle;
  image->GetCenter(middle.data());
  return middle;
}

// One registration, step by step.
class Registration
{
public:
  Registration(const FileRegistrationSettings& settings, const ProgressFunction& progress)
      : Settings(settings), Watch(progress, "registering")
  {
  }

  FileRegistration Run(const RegisteredSide& moving, const RegisteredSide& fixed)
  {
    if (moving.Points && fixed.Points)
    {
      this->TakeLandmarks(*moving.Points, *fixed.Points);
      this->Found.Map = this->Found.Landmarks->Map;
      this->Found.Error = this->Found.Landmarks->Error;
      this->Conclude(MiddleOf(moving.Points->Points));
      return this->Found;
    }
    if (this->Settings.MovingLandmarks && this->Settings.FixedLandmarks)
    {
      this->TakeLandmarks(*this->Settings.MovingLandmarks, *this->Settings.FixedLandmarks);
    }
    if (this->Settings.IsOfImages)
    {
      this->OfImages(moving.File, fixed.File);
    }
    else if (fixed.Points)
    {
      this->OfBodyOntoPoints(moving, fixed.Points->Points);
    }
    else
    {
      this->OntoBody(moving, fixed);
    }
    return this->Found;
  }

private:
  void TakeLandmarks(const NamedPoints& moving, const NamedPoints& fixed)
  {
    NamedPoints one;
    NamedPoints other;
    PairPoints(moving, fixed, one, other);
    LandmarkRegistration made;
    const Status status = RegisterLandmarks(one.Points, other.Points, this->Settings.Kind,
                                            this->Settings.Noise, made);
    if (!status.IsOk())
    {
      throw InputError("the registration " + status.Message());
    }
    if (one.Points.size() < EnoughLandmarks)
    {
      this->Found.Notes.emplace_back("of fewer than eight pairs of landmarks, exchanged or "
                                     "misplaced ones cannot be told from good ones");
    }
    for (std::size_t i = 0; i < one.Points.size(); ++i)
    {
      this->Found.LandmarkNames.push_back(one.Names[i].empty() ? std::to_string(i + 1)
                                                               : one.Names[i]);
      if (made.Weights[i] < SuspiciousWeight)
      {
        this->Found.Notes.push_back("the landmark " + this->Found.LandmarkNames.back() +
                                    " is far from its partner and counts little");
      }
    }
    this->Found.Landmarks = std::move(made);
  }

  // What is given, landmarks, or the middles onto each other.
  Eigen::Affine3d StartOf(const Vector3& moving, const Vector3& fixed, bool hasCentroids) const
  {
    Eigen::Affine3d start = Eigen::Affine3d::Identity();
    if (this->Found.Landmarks)
    {
      start = this->Found.Landmarks->Map;
    }
    else if (this->Settings.Start)
    {
      start = this->IsInverse ? this->Settings.Start->inverse() : *this->Settings.Start;
    }
    else if (hasCentroids && this->Settings.StartsAtCentroids)
    {
      start.translation() = fixed - moving;
    }
    return start;
  }

  void OfImages(const std::filesystem::path& movingFile, const std::filesystem::path& fixedFile)
  {
    const Volume moving = ReadVolume(movingFile, this->Settings.Images);
    const Volume fixed = ReadVolume(fixedFile, this->Settings.Images);
    const Vector3 middle = MiddleOf(moving.Image);
    const Eigen::Affine3d start = this->StartOf(middle, MiddleOf(fixed.Image), true);
    this->Found.Images = RegisterImages(moving.Image, fixed.Image,
                                        {this->Settings.Kind == RegistrationKind::Similarity,
                                         this->Settings.Kind == RegistrationKind::Affine,
                                         ToMapRows(start.inverse())},
                                        this->Watch.Of(0.1, 1.0));
    this->Watch.Require();
    this->Found.Map = ToAffine(this->Found.Images->Back).inverse();
    this->Conclude(middle);
  }

  void OntoBody(const RegisteredSide& moving, const RegisteredSide& fixed)
  {
    const std::string& other = this->Settings.FixedLabel;
    const ComparedBody to =
        BodyOf(fixed.File, other.empty() ? this->Settings.Label : other, this->Settings.Images);
    if (moving.Points)
    {
      this->Match(moving.Points->Points, MiddleOf(moving.Points->Points), to, false);
      this->Conclude(MiddleOf(moving.Points->Points));
      return;
    }
    const ComparedBody from = BodyOf(moving.File, this->Settings.Label, this->Settings.Images);
    this->Match(SomePoints(from.Surface()), from.Centroid(), to, true);
    this->Conclude(from.Centroid());
  }

  void OfBodyOntoPoints(const RegisteredSide& moving, const std::vector<Vector3>& points)
  {
    const ComparedBody from = BodyOf(moving.File, this->Settings.Label, this->Settings.Images);
    if (this->Found.Landmarks)
    {
      this->Found.Landmarks->Map = this->Found.Landmarks->Map.inverse();
    }
    this->IsInverse = true;
    this->Match(points, MiddleOf(points), from, false);
    this->Found.Map = this->Found.Map.inverse();
    this->Conclude(from.Centroid());
  }

  void Match(const std::vector<Vector3>& points, const Vector3& middle, const ComparedBody& body,
             bool isBody)
  {
    const Eigen::Affine3d start = this->StartOf(middle, body.Centroid(), isBody);
    SurfaceRegistration made;
    const Status status = RegisterToSurface(
        points, body.Surface(), start, {this->Settings.Kind, this->Settings.Noise, StepsFromAfar},
        this->Watch.Of(0.1, 1.0), made);
    this->Watch.Require();
    if (!status.IsOk())
    {
      throw InputError("the registration " + status.Message());
    }
    if (points.size() < EnoughPoints)
    {
      this->Found.Notes.emplace_back("fewer than 40 points: the error is larger than predicted "
                                     "where the surface is flat or round");
    }
    if (!made.HasConverged)
    {
      this->Found.Notes.emplace_back("did not come to rest; start it closer, by landmarks");
    }
    this->Found.PointCount = points.size();
    this->Found.Map = made.Map;
    this->Found.Error = made.Error;
    this->Found.Surface = std::move(made);
  }

  void Conclude(const Vector3& middle)
  {
    Matrix3 rotation;
    Matrix3 scaling;
    this->Found.Map.computeRotationScaling(&rotation, &scaling);
    this->Found.Turn = Eigen::AngleAxisd(rotation).angle();
    this->Found.Size = std::cbrt(this->Found.Map.linear().determinant());
    this->Found.Shift = this->Found.Map * middle - middle;
  }

  const FileRegistrationSettings& Settings;
  KernelWatch Watch;
  FileRegistration Found;
  bool IsInverse = false; // the fixed side's points are brought onto the moving body
};
} // namespace

void PairPoints(const NamedPoints& moving, const NamedPoints& fixed, NamedPoints& pairedMoving,
                NamedPoints& pairedFixed)
{
  std::map<std::string, std::size_t> places;
  for (std::size_t i = 0; i < fixed.Names.size(); ++i)
  {
    places.emplace(fixed.Names[i], i);
  }
  const std::map<std::string, std::size_t> all(places);
  const bool areNamed = std::all_of(moving.Names.begin(), moving.Names.end(),
                                    [&places](const std::string& name)
                                    { return !name.empty() && places.erase(name) == 1; });
  if (!areNamed && moving.Points.size() != fixed.Points.size())
  {
    throw InputError("there are " + std::to_string(moving.Points.size()) + " landmarks for " +
                     std::to_string(fixed.Points.size()) +
                     "; give pairs the same names, or both lists the same order and length");
  }
  pairedMoving = moving;
  pairedFixed = fixed;
  if (areNamed)
  {
    pairedFixed = {};
    for (const std::string& name : moving.Names)
    {
      pairedFixed.Names.push_back(name);
      pairedFixed.Points.push_back(fixed.Points[all.at(name)]);
    }
  }
}

FileRegistration RegisterFiles(const RegisteredSide& moving, const RegisteredSide& fixed,
                               const FileRegistrationSettings& settings,
                               const ProgressFunction& progress)
{
  return Registration(settings, progress).Run(moving, fixed);
}
} // namespace palpate
