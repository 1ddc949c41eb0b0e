// stb's decoder, compiled here with the sanitizers and for the fuzzer's eyes: Debian's library has neither.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
