#include "SofteningKey.h"

namespace palpate
{
namespace
{
template <typename T>
std::string_view BytesOf(const T* values, std::size_t count)
{
  // Bytes may alias anything.
  return {reinterpret_cast<const char*>(values), count * sizeof(T)};
}
} // namespace

SofteningKey::SofteningKey(const RadialModel& model, const SofteningSettings& settings)
{
  this->Second.Add("second");
  this->AddNumber(OrganSoftening::Version);
  for (const double coefficient : model.Coefficients())
  {
    this->AddNumber(coefficient);
  }
  this->AddVector(model.CenterWorld());
  const OrganSoftening& numbers = settings.Numbers;
  for (const double number :
       {settings.TissueKilopascal, settings.PoissonRatio, settings.Exaggeration,
        settings.BedPerMillimeter, settings.FreeDegrees, 1.0 * numbers.ElementsAcross,
        1.0 * numbers.DegreeFor(model), 1.0 * numbers.Maps.Degree, numbers.Maps.LargestPatch})
  {
    this->AddNumber(number);
  }
  for (const Vector3& side : settings.FreeSides)
  {
    this->AddVector(side);
  }
}

void SofteningKey::Add(std::string_view use, const TissueMap::Samples& samples, double number)
{
  this->First.Add(use);
  this->Second.Add(use);
  this->AddNumber(number);
  const FieldGrid& grid = samples.Grid;
  for (const int size : grid.Size())
  {
    this->AddNumber(size);
  }
  for (const Vector3& index : {Vector3(0.0, 0.0, 0.0), Vector3(1.0, 0.0, 0.0),
                               Vector3(0.0, 1.0, 0.0), Vector3(0.0, 0.0, 1.0)})
  {
    this->AddVector(grid.PointWorld(index));
  }
  const std::string_view bytes = BytesOf(samples.Values.data(), samples.Values.size());
  this->First.Add(bytes);
  this->Second.Add(bytes);
}

std::string SofteningKey::Text() const
{
  return this->First.Text() + this->Second.Text();
}

void SofteningKey::AddNumber(double number)
{
  this->First.Add(BytesOf(&number, 1));
  this->Second.Add(BytesOf(&number, 1));
}

void SofteningKey::AddVector(const Vector3& vector)
{
  for (const double number : {vector.x(), vector.y(), vector.z()})
  {
    this->AddNumber(number);
  }
}
} // namespace palpate
