// A touchable sphere in a VTK window. The mouse is the hand: move it over the window, and turn the
// wheel to push; "TouchASurface falcon" opens a Novint Falcon instead. Esc switches forces off, f
// on again; a drag with Ctrl rotates the camera.
#include "vtkInteractorStyleHaptic.h"

#include "vtkActor.h"
#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProbeRepresentation.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <iostream>

int main(int argc, char** argv)
{
  vtkNew<vtkSphereSource> sphere; // in mm
  sphere->SetRadius(30.0);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(64);
  sphere->Update();

  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.85, 0.72, 0.55);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetSize(640, 480);
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Initialize();
  window->Render();

  vtkNew<vtkInteractorStyleHaptic> style;
  interactor->SetInteractorStyle(style);
  style->SetDeviceName(argc > 1 ? argv[1] : "simulated");
  style->AddSurface(sphere->GetOutput(), 0.5); // N/mm

  vtkNew<vtkCallbackCommand> tell;
  tell->SetCallback(
      [](vtkObject*, unsigned long event, void*, void* data)
      {
        if (event == vtkInteractorStyleHaptic::FaultEvent)
        {
          std::cout << static_cast<const char*>(data) << std::endl;
          return;
        }
        const bool isBegin = event == vtkInteractorStyleHaptic::ContactBeginEvent;
        std::cout << (isBegin ? "touched" : "let go") << std::endl;
      });
  style->AddObserver(vtkInteractorStyleHaptic::ContactBeginEvent, tell);
  style->AddObserver(vtkInteractorStyleHaptic::ContactEndEvent, tell);
  style->AddObserver(vtkInteractorStyleHaptic::FaultEvent, tell);

  if (!style->StartTouch())
  {
    return EXIT_FAILURE;
  }
  interactor->Start();
  style->StopTouch();
  return EXIT_SUCCESS;
}
