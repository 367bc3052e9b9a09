#include "TouchPeer.h"

#include "CommandProgress.h"
#include "Console.h"
#include "IgtlConversion.h"
#include "IgtlTouchState.h"
#include "Refusal.h"
#include "SceneSurfaces.h"

#include <chrono>
#include <thread>

namespace palpate::cli
{
namespace
{
constexpr int FarewellMilliseconds = 200;
}

TouchPeer::TouchPeer(const std::string& address, const PreparedTouch& touch, Console& console)
    : Screen(console)
{
  IgtlPeer peer;
  RequireInput(ParseIgtlPeer(address, peer));
  this->Link.Offer(SurfaceMessagesOf(DisplayedSurfaces(touch.Settings, ProgressOn(console))));
  console.EndProgress();
  RequireInput(this->Link.Open(peer));
}

TouchPeer::~TouchPeer()
{
  this->Link.EndTouch();
  for (int waited = 0;
       waited < FarewellMilliseconds && this->Link.HasPeer() && !this->Link.IsAllSent(); ++waited)
  {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  this->TellProblems();
}

void TouchPeer::Show(const TouchState& newest)
{
  if (const std::optional<IgtlTouch> shown = IgtlTouchOf(newest))
  {
    this->Link.Show(*shown);
  }
  this->TellProblems();
}

void TouchPeer::TellProblems()
{
  for (const std::string& problem : this->Link.TakeProblems())
  {
    this->Screen.Note(problem);
  }
  while (this->Link.TakeImage())
  {
    // Images are for palpate link.
  }
}
} // namespace palpate::cli
