// Called by the leak sanitizer, which finds it by this name; otherwise unused. ITK's NRRD library
// keeps its half-read image when a damaged file makes it give up.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the sanitizer chose the name
extern "C" const char* __lsan_default_suppressions();

const char* __lsan_default_suppressions()
{
  return "leak:libITKNrrdIO\n";
}
