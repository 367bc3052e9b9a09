#pragma once

#include "CurveActor.h"
#include "PalpateInteractionModule.h"
#include "SlicePosition.h"

class vtkRenderer;
class vtkWorkspaceRepresentation;

namespace palpate
{
/// A device's workspace as thin lines, in space or in a slice.
class PALPATEINTERACTION_EXPORT WorkspaceLines
{
public:
  void AddTo(vtkRenderer* renderer) const;
  void RemoveFrom(vtkRenderer* renderer) const;
  /// Its edges. Null shows nothing.
  void Update(vtkWorkspaceRepresentation* workspace);
  /// What a slice cuts out of it. Null shows nothing.
  void Update(vtkWorkspaceRepresentation* workspace, const SlicePosition& slice);
  const CurveActor& Drawn() const { return this->Lines; }

private:
  bool Show(vtkWorkspaceRepresentation* workspace, double width);

  CurveActor Lines;
};
} // namespace palpate
