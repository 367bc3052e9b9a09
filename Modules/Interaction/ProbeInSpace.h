#pragma once

#include "PalpateInteractionModule.h"
#include "ViewProps.h"

#include "vtkActor.h"
#include "vtkNew.h"

class vtkProbeRepresentation;

namespace palpate
{
/// A probe in 3D: the tool at the probe (translucent) and at the proxy (solid), and the force as an
/// arrow.
class PALPATEINTERACTION_EXPORT ProbeInSpace : public ViewProps
{
public:
  ProbeInSpace();
  /// Null shows nothing.
  void Update(vtkProbeRepresentation* probe);

private:
  vtkNew<vtkActor> Probe;
  vtkNew<vtkActor> Proxy;
  vtkNew<vtkActor> Arrow;
};
} // namespace palpate
