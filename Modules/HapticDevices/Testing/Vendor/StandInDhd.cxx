// Behaves as the reference of Force Dimension's SDK 3 says of the calls of one device.
#include "StandIn.h"

#include <cmath>

extern "C"
{
  StandInArm StandIn;

  int dhdOpen()
  {
    StandIn.IsOpen = !StandIn.IsMissing;
    return StandIn.IsMissing ? -1 : 3;
  }
  int dhdClose(char)
  {
    StandIn.IsOpen = false;
    return 0;
  }
  const char* dhdGetSystemName(char)
  {
    return "stand-in";
  }
  const char* dhdErrorGetLastStr()
  {
    return "no device found";
  }
  int dhdEnableForce(unsigned char, char id)
  {
    return id == 3 ? 0 : -1;
  }
  int dhdGetPositionAndOrientationFrame(double* x, double* y, double* z, double (*rows)[3], char)
  {
    *x = StandIn.Place[0];
    *y = StandIn.Place[1];
    *z = StandIn.Place[2];
    // A quarter of a turn about the SDK's z, which is up: x to y.
    const double turn[3][3] = {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}};
    for (int row = 0; row < 3; ++row)
    {
      for (int column = 0; column < 3; ++column)
      {
        rows[row][column] = turn[row][column];
      }
    }
    return StandIn.Fails ? -1 : 1; // 1: the time guard returned the last one
  }
  unsigned dhdGetButtonMask(char)
  {
    return static_cast<unsigned>(StandIn.Buttons.load());
  }
#ifndef STAND_IN_KNOWS_NO_WRIST
  bool dhdHasActiveWrist(char id)
  {
    return id == 3 && StandIn.Turns;
  }
#endif
  int dhdSetForceAndTorqueAndGripperForce(double x, double y, double z, double a, double b,
                                          double c, double, char)
  {
    StandIn.Force[0] = x;
    StandIn.Force[1] = y;
    StandIn.Force[2] = z;
    StandIn.Torque[0] = a;
    StandIn.Torque[1] = b;
    StandIn.Torque[2] = c;
    const double force = std::sqrt(x * x + y * y + z * z);
    const double torque = std::sqrt(a * a + b * b + c * c);
    StandIn.LargestForce = std::fmax(StandIn.LargestForce, force);
    StandIn.LargestTorque = std::fmax(StandIn.LargestTorque, torque);
    StandIn.Pushes += force > 0.0 || torque > 0.0 ? 1 : 0;
    ++StandIn.Steps;
    return StandIn.Fails ? -1 : 0;
  }
}
