#pragma once

#include "PalpateInteractionModule.h"

#include "vtkNew.h"

class vtkActor;
class vtkProbeRepresentation;
class vtkRenderer;

namespace palpate
{
/// A probe in 3D: the tool at the probe (translucent) and at the proxy (solid), and the force as an
/// arrow.
class PALPATEINTERACTION_EXPORT ProbeInSpace
{
public:
  ProbeInSpace();
  ~ProbeInSpace();
  ProbeInSpace(const ProbeInSpace&) = delete;
  ProbeInSpace& operator=(const ProbeInSpace&) = delete;

  void AddTo(vtkRenderer* renderer) const;
  void RemoveFrom(vtkRenderer* renderer) const;
  /// Null shows nothing.
  void Update(vtkProbeRepresentation* probe);

private:
  vtkNew<vtkActor> Probe;
  vtkNew<vtkActor> Proxy;
  vtkNew<vtkActor> Arrow;
};
} // namespace palpate
