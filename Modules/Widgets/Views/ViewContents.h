#pragma once

#include "NearestOnSurfaces.h"
#include "ShownCorrection.h"
#include "ShownDrawing.h"
#include "ShownImages.h"
#include "ShownMarks.h"
#include "StructurePlaces.h"
#include "StudyPipeline.h"
#include "StudyState.h"
#include "StudyTouch.h"
#include "YieldingSurface.h"

#include "vtkCrosshair.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkProbeRepresentation.h"
#include "vtkSmartPointer.h"
#include "vtkSurfaceDisplay.h"
#include "vtkVolume.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace palpate
{
/// The objects of Interaction that all views of a window share, updated from the study. Their
/// events tell views when to draw.
class ViewContents
{
public:
  ViewContents();

  /// Volume, labels, surfaces, landmarks and measurements.
  void Show(const StudyState& state, const StudyPipeline& pipeline);
  /// Crosshair, window and opacity, where the view specifies them.
  void ShowView(const StudyView& view);
  /// The tool and its contact; nothing if not touching.
  void ShowTouch(const StudyTouchReading& reading, bool isTouching);
  /// Drilled structures, and the outlines of cuts. Returns whether different objects are shown now.
  bool ShowDrilled(const StudyDrillReading& reading);
  /// The device's workspace; nothing if `isShown` is false.
  void ShowWorkspace(const WorkspaceFrame& frame, const Eigen::AlignedBox3d& box, bool isShown);
  /// See ShownMarks.
  void ShowPreview(const std::optional<StudyMeasurement>& preview)
  {
    this->Marks.ShowPreview(preview);
  }
  /// See ShownMarks.
  void ShowTrial(const TrialMarks& marks) { this->Marks.ShowTrial(marks); }
  /// From now on ShowTouch shows the tool where the hand is, whatever it meets: it dents nothing.
  void ShowHandOnly(bool isOn) { this->IsHandOnly = isOn; }
  /// From now on ShowTouch shows no force and no depth, which are to be felt only.
  void HideForce(bool isOn) { this->IsForceHidden = isOn; }
  /// The organ that is drawn by touch; with touches and next places as marks.
  void ShowDrawing(const DrawnOrgan& organ, const StudyDrawing& drawing, bool areMarked);
  /// A structure that a hand holds, where it holds it, instead of where it is; null: none is held.
  void ShowHeld(int id, vtkPolyData* surface);
  /// The structure that is being corrected; before Show.
  void ShowCorrection(const StudyState& state, const StudyCorrected& corrected)
  {
    this->Corrected.Show(state, corrected);
  }
  /// See ShownCorrection.
  void ShowStroke(vtkPolyData* outline, bool erases)
  {
    this->Corrected.ShowStroke(outline, erases);
  }
  /// See ShownMarks.
  void ShowRing(const std::vector<Vector3>& ring, const std::string& text)
  {
    this->Marks.ShowRing(ring, text);
  }
  /// Of measurements' values.
  void SetLengthUnit(LengthUnit unit) { this->Marks.SetLengthUnit(unit); }
  /// `view` with the user's crosshair, window and opacity.
  StudyView WithViewOf(StudyView view) const;

  vtkImageDisplay* Images() const { return this->Pictures.Display(); }
  const ShownImages& Volumes() const { return this->Pictures; }
  vtkCrosshair* Crosshair() const { return this->CrosshairShown; }
  vtkLandmarks* Landmarks() const { return this->Marks.Display(); }
  vtkProbeRepresentation* Probe() const { return this->ProbeShown; }
  const ShownDrawing& Drawing() const { return this->Drawn; }
  vtkSurfaceDisplay* Held() const { return this->HeldShown; }
  const ShownCorrection& Correction() const { return this->Corrected; }
  vtkSurfaceDisplay* Workspace() const { return this->WorkspaceShown; }
  /// By the structure's label.
  const std::map<int, vtkSmartPointer<vtkSurfaceDisplay>>& Surfaces() const
  {
    return this->SurfacesShown;
  }
  /// Removed parts of drilled structures, as outlines in slices; by the structure's label.
  const std::map<int, vtkSmartPointer<vtkSurfaceDisplay>>& Cuts() const { return this->CutsShown; }
  /// Surfaces of forbidden structures that are not shown as surfaces; only their outlines are
  /// drawn.
  const std::map<int, vtkSmartPointer<vtkSurfaceDisplay>>& Outlines() const
  {
    return this->OutlinesShown;
  }
  /// Sub-voxel structures: themselves in the 3D view, their contours in slices.
  const std::map<int, vtkSmartPointer<vtkVolume>>& Fields() const { return this->FieldsShown; }

  /// Outlines these structures in 3D and makes their contours thicker in slices, and no others.
  void Highlight(const std::set<int>& ids);

  /// The visible structure of the labels at a point (world, mm); 0 if there is none.
  int StructureAt(const Vector3& pointWorld) const { return this->Places.At(pointWorld); }
  /// The structure of a picked object (see vtkSpaceView::PickObject) at a point; 0 if there is
  /// none.
  int StructureAt(const vtkObject* picked, const Vector3& pointWorld) const;
  /// A point in the middle of a structure (world, mm); none if neither its label nor anything of
  /// it is there.
  std::optional<Vector3> CenterOf(int id) const;

  /// The value and the names of the structures at a point (world, mm), for the status line.
  std::string TextAt(const Vector3& pointWorld) const { return this->Pictures.TextAt(pointWorld); }

private:
  void ShowSurfaces(const StudyState& state, const StudyPipeline& pipeline);
  void ShowOutlines(const StudyState& state, const StudyPipeline& pipeline);
  void FollowSurfaces();
  void ShowSurface(const SceneStructure& structure, vtkPolyData* surface);
  vtkPolyData* ShowYielding(const SceneStructure& structure, const StudyPipeline& pipeline);
  void ShowOpacities(const StudyState& state);
  void ShowErrorScale(const StudyView& view);
  bool HoldsAnother(int id) const;
  void ShowHighlight(int id);
  double BallRadius() const;
  void ShowDepth(const Vector3& toolWorld);
  void ShowDent(const StudyTouchReading& reading, bool isTouching);
  void ShowField(const SceneStructure& structure, const std::shared_ptr<const ScalarField>& field);
  void ShowNewest(int label);
  void ShowTool(const TouchToolSettings& tool);

  ShownImages Pictures;
  vtkNew<vtkCrosshair> CrosshairShown;
  ShownMarks Marks;
  ShownDrawing Drawn;
  ShownCorrection Corrected;
  vtkNew<vtkProbeRepresentation> ProbeShown;
  NearestOnSurfaces Around; // the tool
  vtkNew<vtkSurfaceDisplay> HeldShown;
  vtkNew<vtkSurfaceDisplay> WorkspaceShown;
  std::map<int, vtkSmartPointer<vtkSurfaceDisplay>> SurfacesShown;
  std::map<int, vtkSmartPointer<vtkSurfaceDisplay>> CutsShown;
  std::map<int, vtkSmartPointer<vtkSurfaceDisplay>> OutlinesShown;
  std::map<int, vtkSmartPointer<vtkVolume>> FieldsShown;
  std::map<int, std::unique_ptr<YieldingSurface>> Yielding;
  std::set<int> Touchable; // ids
  bool IsHandOnly = false;
  bool IsForceHidden = false;
  std::set<int> Highlighted;
  StructurePlaces Places;

  // The displayed products; they are shared and never changed.
  std::map<int, vtkPolyData*> SurfaceSources;
  std::map<int, vtkPolyData*> OutlineSources;
  std::map<int, std::shared_ptr<const ScalarField>> FieldSources;
  std::map<int, std::shared_ptr<const ScalarField>> DrilledFields;
  ///@{ Of FollowSurfaces: the structures, and where it left the crosshair.
  std::set<int> Followed;
  Vector3 FollowedWorld = Vector3::Zero();
  ///@}
  std::optional<TouchToolSettings> Tool;
  std::array<Vector3, 8> WorkspaceCorners; // of the box that is shown
};
} // namespace palpate
