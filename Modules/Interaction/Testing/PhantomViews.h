#pragma once

#include "FourViews.h"
#include "SyntheticFit.h"

#include <cmath>

namespace palpate::test
{
/// Four views of a prostate-like phantom on an oblique grid, with its mask, its surface, a model
/// coloured by its error, two landmarks, and a tool that presses against the surface.
struct PhantomViews
{
  PhantomViews(int width, int height) : Views(this->Fit.Mri.Image, width, height)
  {
    const Vector3& center = SyntheticFit::Center;
    this->Views.Crosshair->SetPositionWorld(center.data());
    const int layer = this->Views.Images->AddLabels(this->Fit.Result.Mask);
    this->Views.Images->SetLabelColor(layer, 1, 0.9, 0.6, 0.0, 0.6);
    this->Truth->SetSurface(this->Fit.Result.Surface);
    this->Truth->SetColor(0.34, 0.71, 0.91);
    this->Truth->SetOpacity(0.0);
    this->Model->SetSurface(this->Fit.Result.ModelSurface);
    this->Model->SetColor(0.8, 0.47, 0.65);
    this->Model->SetColorArray("DistanceToSurface");
    this->Views.AddSurface(this->Truth);
    this->Views.AddSurface(this->Model);
    this->PlaceLandmarks();
    this->PlaceProbe();
  }

  SyntheticFit Fit;
  vtkNew<vtkSurfaceDisplay> Truth;
  vtkNew<vtkSurfaceDisplay> Model;
  FourViews Views;

private:
  Vector3 SurfacePoint(const Vector3& direction) const
  {
    return this->Fit.Result.Radial()->PointWorld(direction.normalized());
  }
  void PlaceLandmarks()
  {
    const Vector3 left = this->SurfacePoint(Vector3::UnitX());
    const Vector3 right = this->SurfacePoint(-Vector3::UnitX());
    this->Views.Landmarks->AddLandmark("left", left.data());
    this->Views.Landmarks->AddLandmark("right", right.data());
    this->Views.Landmarks->AddDistance(0, 1);
  }
  // 4 mm deep, from the front, slightly from the left.
  void PlaceProbe()
  {
    const Vector3 outward = Vector3(0.5, -1.0, 0.0).normalized();
    const Vector3 proxy = this->SurfacePoint(outward) + 2.0 * outward;
    const Vector3 probe = proxy - 4.0 * outward;
    vtkProbeRepresentation* tool = this->Views.Probe;
    tool->SetToolSphere(2.0);
    tool->SetProbePosition(probe.x(), probe.y(), probe.z());
    tool->SetProxyPosition(proxy.x(), proxy.y(), proxy.z());
    tool->SetForce(1.5 * outward.x(), 1.5 * outward.y(), 1.5 * outward.z());
    tool->InContactOn();
    tool->VisibilityOn();
  }
};
} // namespace palpate::test
