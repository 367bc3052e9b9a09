// Behaves as the reference of OpenHaptics 3.5 says of the calls of one device: forces are set
// within a frame of a scheduled callback, errors are asked for.
#include "StandIn.h"

#include <chrono>
#include <cmath>
#include <thread>

extern "C"
{
  struct ErrorInfo
  {
    unsigned Code;
    int Internal;
    unsigned Device;
  };

  StandInArm StandIn;

  static std::thread Scheduler;
  static std::atomic<bool> IsScheduled{false};
  static unsigned (*Callback)(void*) = nullptr;
  static void* CallbackData = nullptr;
  static std::atomic<bool> InFrame{false};
  static std::atomic<bool> HasMisused{false};
  // Of the frame: none, unless they are set in it.
  static double Force[3];
  static double Torque[3];

  static double Display(const double* values, std::atomic<double>* shown)
  {
    double square = 0.0;
    for (int part = 0; part < 3; ++part)
    {
      shown[part] = values[part];
      square += values[part] * values[part];
    }
    return std::sqrt(square);
  }

  unsigned hdInitDevice(const char*)
  {
    StandIn.IsOpen = !StandIn.IsMissing;
    return StandIn.IsMissing ? 0xFFFFFFFFU : 7U;
  }
  void hdDisableDevice(unsigned)
  {
    StandIn.IsOpen = false;
  }
  void hdMakeCurrentDevice(unsigned device)
  {
    HasMisused = HasMisused || device != 7U;
  }
  void hdEnable(unsigned what)
  {
    HasMisused = HasMisused || what != 0x4000U;
  }
  void hdBeginFrame(unsigned)
  {
    HasMisused = HasMisused || InFrame;
    InFrame = true;
    for (int part = 0; part < 3; ++part)
    {
      Force[part] = 0.0;
      Torque[part] = 0.0;
    }
  }
  void hdEndFrame(unsigned)
  {
    HasMisused = HasMisused || !InFrame;
    InFrame = false;
    const double force = Display(Force, StandIn.Force);
    const double torque = Display(Torque, StandIn.Torque);
    StandIn.LargestForce = std::fmax(StandIn.LargestForce, force);
    StandIn.LargestTorque = std::fmax(StandIn.LargestTorque, torque);
    StandIn.Pushes += force > 0.0 || torque > 0.0 ? 1 : 0;
    ++StandIn.Steps;
  }
  void hdGetDoublev(unsigned what, double* values)
  {
    if (what == 0x2050)
    {
      for (int part = 0; part < 3; ++part)
      {
        values[part] = StandIn.Place[part];
      }
    }
    else if (what == 0x2052)
    {
      // A quarter of a turn about z, column by column.
      const double transform[16] = {0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
      for (int part = 0; part < 16; ++part)
      {
        values[part] = transform[part];
      }
    }
    else if (what == 0x2551)
    {
      const double box[6] = {-210, -110, -85, 210, 205, 130};
      for (int part = 0; part < 6; ++part)
      {
        values[part] = box[part];
      }
    }
    else if (what == 0x2603)
    {
      *values = 7.9;
    }
    else if (what == 0x2622 && StandIn.Turns)
    {
      *values = 300.0;
    }
  }
  void hdGetIntegerv(unsigned what, int* value)
  {
    const int degrees = StandIn.Turns ? 6 : 3;
    *value = what == 0x2000 ? StandIn.Buttons.load() : what == 0x2554 ? degrees : 0;
  }
  void hdSetDoublev(unsigned what, const double* values)
  {
    const bool isTorque = what == 0x2701 && StandIn.Turns;
    HasMisused = HasMisused || !(what == 0x2700 || isTorque) || !InFrame;
    for (int part = 0; part < 3; ++part)
    {
      (isTorque ? Torque : Force)[part] = values[part];
    }
  }
  ErrorInfo hdGetError()
  {
    const unsigned code = HasMisused ? 0x0102U : StandIn.IsMissing ? 0x0300U : 0U;
    return {StandIn.Fails ? 0x0302U : code, 0, 7U};
  }
  unsigned long hdScheduleAsynchronous(unsigned (*callback)(void*), void* data, unsigned short)
  {
    Callback = callback;
    CallbackData = data;
    return 1;
  }
  void hdStartScheduler()
  {
    IsScheduled = true;
    Scheduler = std::thread(
        []
        {
          bool goesOn = true;
          while (IsScheduled)
          {
            goesOn = goesOn && Callback(CallbackData) == 1U;
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          }
        });
  }
  void hdStopScheduler()
  {
    IsScheduled = false;
    if (Scheduler.joinable())
    {
      Scheduler.join();
    }
  }
}
