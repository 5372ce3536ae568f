// The common tongue of GLSL and C++ (GLM): geometry/ and methods/ are compiled as both, so that the arithmetic that
// ships can be run under sanitizers and against double precision. No swizzles, no GLSL-only built-ins. C++ gives `real`
// and the vectors made of it.
#ifndef RELIEVO_MACROS_GLSL
#define RELIEVO_MACROS_GLSL
#ifdef __cplusplus
#define OUT(T) T&
#define INOUT(T) T&
#define FUNC inline
#else
#define OUT(T) out T
#define INOUT(T) inout T
#define FUNC
#define real float
#endif
#endif
