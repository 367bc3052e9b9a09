/**
 * @class vtkLinkedView
 * @brief what a renderer shows of things that it shares with other views
 *
 * What vtkSliceView and vtkSpaceView have in common. Give a view a renderer of any render window,
 * and what is shown: a volume with labels (vtkImageDisplay), surfaces (vtkSurfaceDisplay),
 * landmarks, a haptic tool and its device's workspace, the point through which slices go
 * (vtkCrosshair). All of them may be shared with other views. The view brings itself up to date
 * whenever the renderer draws, and does then only what has to be done anew.
 */
#ifndef vtkLinkedView_h
#define vtkLinkedView_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkObject.h"

#include <memory> // For what is shared

class vtkCrosshair;
class vtkImageDisplay;
class vtkLandmarks;
class vtkProbeRepresentation;
class vtkRenderer;
class vtkSurfaceDisplay;
class vtkWorkspaceRepresentation;

class PALPATEINTERACTION_EXPORT vtkLinkedView : public vtkObject
{
public:
  vtkAbstractTypeMacro(vtkLinkedView, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Where it is drawn. The view takes its things away from the renderer before. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /** What is shown; null shows none. */
  virtual void SetImageDisplay(vtkImageDisplay* display);
  vtkImageDisplay* GetImageDisplay();
  void SetCrosshair(vtkCrosshair* crosshair);
  vtkCrosshair* GetCrosshair();
  void SetLandmarks(vtkLandmarks* landmarks);
  vtkLandmarks* GetLandmarks();
  void SetProbe(vtkProbeRepresentation* probe);
  vtkProbeRepresentation* GetProbe();
  void SetWorkspace(vtkWorkspaceRepresentation* workspace);
  vtkWorkspaceRepresentation* GetWorkspace();
  virtual void AddSurface(vtkSurfaceDisplay* surface) = 0;
  virtual void RemoveSurface(vtkSurfaceDisplay* surface) = 0;
  ///@}

  ///@{
  /** Whether slices run along the volume's own axes (the default) or along the body's. */
  vtkSetMacro(AlongImage, bool);
  vtkGetMacro(AlongImage, bool);
  vtkBooleanMacro(AlongImage, bool);
  ///@}
  ///@{
  /** Words, letters and bars over the picture. On by default. */
  vtkSetMacro(AnnotationVisibility, bool);
  vtkGetMacro(AnnotationVisibility, bool);
  vtkBooleanMacro(AnnotationVisibility, bool);
  ///@}

  /** Brings everything up to date; done whenever the renderer draws. */
  void Update();

protected:
  vtkLinkedView();
  /** Views end with SetRenderer(nullptr): what they show is gone when this runs. */
  ~vtkLinkedView() override;

  /** What the view shows, to its renderer and away from it. */
  virtual void AddTo(vtkRenderer* renderer) = 0;
  virtual void RemoveFrom(vtkRenderer* renderer) = 0;
  /** Brings it up to date for the renderer, which there is. */
  virtual void UpdateFor(vtkRenderer* renderer) = 0;

private:
  vtkLinkedView(const vtkLinkedView&) = delete;
  void operator=(const vtkLinkedView&) = delete;

  bool AlongImage = true;
  bool AnnotationVisibility = true;

  struct Shared;
  std::unique_ptr<Shared> Given;
};

#endif
