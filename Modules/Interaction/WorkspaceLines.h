#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SlicePosition.h"

class vtkRenderer;
class vtkWorkspaceRepresentation;

namespace palpate
{
/// A device's workspace as thin lines, in 3D or in a slice.
class PALPATEINTERACTION_EXPORT WorkspaceLines
{
public:
  void AddTo(vtkRenderer* renderer) const;
  void RemoveFrom(vtkRenderer* renderer) const;
  /// Its edges. Null shows nothing.
  void Update(vtkWorkspaceRepresentation* workspace);
  /// Its cross-section with a slice. Null shows nothing.
  void Update(vtkWorkspaceRepresentation* workspace, const SlicePosition& slice);
  const CurveActor& Drawn() const { return this->Lines; }

private:
  bool Show(vtkWorkspaceRepresentation* workspace, double width);

  CurveActor Lines;
};
} // namespace palpate
