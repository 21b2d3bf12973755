// LazyPRM, LazyPRM* and SORRT* of OMPL 1.5.2 do not free all states they took: not ours to report.
#ifdef PRAXIS_SANITIZED
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libompl.so\n";
}
#endif
