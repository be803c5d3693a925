// Suppressions for sanitizers. Mesa keeps a little memory of each OSMesa context forever, and fontconfig of each font
// that a chart uses. llvmpipe destroys a fence's mutex while one of its own threads leaves it. They are given here,
// where the drivers are opened, so that other findings stay readable; without sanitizers this file is empty.
#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CLAQUE_LEAK_CHECKER 1
#endif
#if __has_feature(thread_sanitizer)
#define CLAQUE_RACE_CHECKER 1
#endif
#endif
#if defined(__SANITIZE_ADDRESS__)
#define CLAQUE_LEAK_CHECKER 1
#endif
#if defined(__SANITIZE_THREAD__)
#define CLAQUE_RACE_CHECKER 1
#endif

#if defined(CLAQUE_LEAK_CHECKER)
extern "C" __attribute__((visibility("default"))) const char *__lsan_default_suppressions();
const char *__lsan_default_suppressions()
{
    return "leak:libOSMesa\nleak:libEGL\nleak:swrast_dri\nleak:libgallium\nleak:libGLX_mesa\n"
           "leak:libfontconfig\n";
}
// What a program says is its own: no list of what was suppressed.
extern "C" __attribute__((visibility("default"))) const char *__lsan_default_options();
const char *__lsan_default_options() { return "print_suppressions=0"; }
#endif

#if defined(CLAQUE_RACE_CHECKER)
extern "C" __attribute__((visibility("default"))) const char *__tsan_default_suppressions();
const char *__tsan_default_suppressions() { return "race:libOSMesa.so\nrace:swrast_dri.so\n"; }
#endif

namespace contexts
{

// Called by make_offscreen, so that the linker includes this file.
void tell_leak_checker() {}

}  // namespace contexts
