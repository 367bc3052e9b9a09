#include "SingleBlasThread.h"

#include <mutex>

extern "C" __attribute__((weak)) int openblas_get_num_threads();
extern "C" __attribute__((weak)) void openblas_set_num_threads(int count);

namespace palpate
{
namespace
{
// The setting is the program's: the first user changes it, the last one restores it.
struct ThreadSetting
{
  std::mutex Changing;
  int Users = 0;
  int Before = 0;

  static ThreadSetting& Instance()
  {
    static ThreadSetting setting;
    return setting;
  }
  static bool Exists()
  {
    return openblas_get_num_threads != nullptr && openblas_set_num_threads != nullptr;
  }
};
} // namespace

SingleBlasThread::SingleBlasThread()
{
  ThreadSetting& setting = ThreadSetting::Instance();
  const std::lock_guard<std::mutex> alone(setting.Changing);
  if (++setting.Users == 1 && ThreadSetting::Exists())
  {
    setting.Before = openblas_get_num_threads();
    openblas_set_num_threads(1);
  }
}

SingleBlasThread::~SingleBlasThread()
{
  ThreadSetting& setting = ThreadSetting::Instance();
  const std::lock_guard<std::mutex> alone(setting.Changing);
  if (--setting.Users == 0 && ThreadSetting::Exists())
  {
    openblas_set_num_threads(setting.Before);
  }
}
} // namespace palpate
