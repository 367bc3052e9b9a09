/**
 * @class vtkProbeRepresentation
 * @brief a haptic tool in linked views: device pose (probe), drawn pose (proxy), force and contact
 *
 * 3D views show the tool's shape at the probe (translucent) and at the proxy (solid), the force as
 * an arrow from the proxy, and colour surfaces around the contact. Slices show the cross-sections
 * of both shapes, and the force's component in the slice.
 *
 * The tool is a sphere or a closed surface of triangles in its own frame (mm);
 * palpate::MakeToolSurface makes one from a servo's tool. Set poses and force from the servo before
 * views are drawn; non-finite numbers are ignored, and the last valid values are kept.
 */
#ifndef vtkProbeRepresentation_h
#define vtkProbeRepresentation_h

#include "PalpateInteractionModule.h" // For export macro
#include "vtkMatrix4x4.h"             // For the poses
#include "vtkObject.h"
#include "vtkPolyData.h" // For the tool
#include "vtkSmartPointer.h"

#include <array>

#ifndef __VTK_WRAP__
#include "Vector3.h"
#endif

class PALPATEINTERACTION_EXPORT vtkProbeRepresentation : public vtkObject
{
public:
  static vtkProbeRepresentation* New();
  vtkTypeMacro(vtkProbeRepresentation, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The tool, a closed surface; the default is a sphere of 1 mm. A point (radius 0) is drawn as
   * one of 0.5 mm. */
  void SetToolSphere(double radius);
  vtkSetSmartPointerMacro(Tool, vtkPolyData);
  vtkGetSmartPointerMacro(Tool, vtkPolyData);
  ///@}
  /** How near its surface is to the origin of the tool's frame, mm: the radius of a sphere, a
   * capsule, and a drill's ball. */
  double GetToolRadius();

  ///@{
  /**
   * Pose of the tool: position in the world, mm; orientation as a unit quaternion (w, x, y, z) from
   * the tool's frame to the world.
   */
  void SetProbePose(const double position[3], const double orientation[4]);
  void SetProxyPose(const double position[3], const double orientation[4]);
  void SetProbePosition(double x, double y, double z);
  void SetProxyPosition(double x, double y, double z);
#ifndef __VTK_WRAP__
  // The same, with orientations as TouchState has them (x, y, z, w).
  void SetProbePose(const palpate::Vector3& position, const std::array<double, 4>& orientation);
  void SetProxyPose(const palpate::Vector3& position, const std::array<double, 4>& orientation);
#endif
  ///@}
  ///@{
  /** From the tool's frame to the world. Do not change. */
  vtkGetSmartPointerMacro(ProbeMatrix, vtkMatrix4x4);
  vtkGetSmartPointerMacro(ProxyMatrix, vtkMatrix4x4);
#ifndef __VTK_WRAP__
  palpate::Vector3 ProxyWorld() const; // the proxy's position
#endif
  ///@}

  ///@{
  /** Force on the hand, N, world axes. */
  void SetForce(double x, double y, double z);
  vtkGetVector3Macro(Force, double);
  ///@}
  ///@{
  /** Length of its arrow, mm per N. Default: 10. */
  vtkSetClampMacro(ForceScale, double, 0.0, 1e4);
  vtkGetMacro(ForceScale, double);
  ///@}

  ///@{
  /** Whether the tool is in contact. */
  vtkSetMacro(InContact, bool);
  vtkGetMacro(InContact, bool);
  vtkBooleanMacro(InContact, bool);
  ///@}
  ///@{
  /** The point of the surface that is touched (world, mm), for tools that are no spheres. None by
   * default: then it is where a ball of the tool's radius touches, against the force. */
  void SetFoot(double x, double y, double z);
  void ClearFoot();
  vtkGetVector3Macro(Foot, double);
  vtkGetMacro(HasFoot, bool);
#ifndef __VTK_WRAP__
  palpate::Vector3 ContactWorld(); // that point, or the proxy's position without force
#endif
  ///@}
  ///@{
  /** Surfaces are coloured up to this distance (mm) from the proxy's tool while in contact.
   * Default: 4. */
  vtkSetClampMacro(ContactRadius, double, 0.0, 1e3);
  vtkGetMacro(ContactRadius, double);
  ///@}
  ///@{
  /** How deep the tool is, mm, as is written beside it; negative, the default: the distance of
   * probe and proxy. What yields is shown with both at one place. */
  vtkSetMacro(Depth, double);
  vtkGetMacro(Depth, double);
  ///@}
  ///@{
  /** The nearest place of what is around (world, mm), to which 3D views draw a line with its length
   * while the tool is not in contact. None by default. */
  void SetNearestPoint(double x, double y, double z);
  void ClearNearestPoint();
  vtkGetVector3Macro(NearestPoint, double);
  vtkGetMacro(HasNearestPoint, bool);
  ///@}
  ///@{
  /** Colour of the contact: red, green, blue. */
  vtkSetVector3Macro(ContactColor, double);
  vtkGetVector3Macro(ContactColor, double);
  ///@}
  ///@{
  /** Colour of the tool: red, green, blue. */
  vtkSetVector3Macro(Color, double);
  vtkGetVector3Macro(Color, double);
  ///@}
  ///@{
  vtkSetMacro(Visibility, bool);
  vtkGetMacro(Visibility, bool);
  vtkBooleanMacro(Visibility, bool);
  ///@}

protected:
  vtkProbeRepresentation();
  ~vtkProbeRepresentation() override = default;

private:
  vtkProbeRepresentation(const vtkProbeRepresentation&) = delete;
  void operator=(const vtkProbeRepresentation&) = delete;

  void SetPose(vtkMatrix4x4* matrix, const double position[3], const double orientation[4]);

  vtkSmartPointer<vtkPolyData> Tool;
  vtkSmartPointer<vtkMatrix4x4> ProbeMatrix;
  vtkSmartPointer<vtkMatrix4x4> ProxyMatrix;
  double Force[3] = {0.0, 0.0, 0.0};
  double ForceScale = 10.0;
  bool InContact = false;
  double Foot[3] = {0.0, 0.0, 0.0};
  bool HasFoot = false;
  double ContactRadius = 4.0;
  double Depth = -1.0;
  double NearestPoint[3] = {0.0, 0.0, 0.0};
  bool HasNearestPoint = false;
  double ContactColor[3] = {0.84, 0.37, 0.0};
  double Color[3] = {0.34, 0.71, 0.91};
  bool Visibility = true;
};

#endif
