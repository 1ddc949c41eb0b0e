/* Functions of GL after version 1.1. They are asked for when a case calls them, because libraries need not export them; a GL that has
   none ends the case with "not run". */
#ifndef FUNCTIONS_H
#define FUNCTIONS_H

#ifndef APIENTRY
#define APIENTRY
#endif

/* Ends the case if GL's version is below `version` (14: 1.4) and `extension` (0: none) is missing. */
void (*later_function(const char* name, int version, const char* extension))(void);

#define LATER(name, version, extension, parameters) \
    ((void(APIENTRY*) parameters)later_function(name, version, extension))

#define glActiveTexture LATER("glActiveTexture", 13, 0, (GLenum))
#define glBindFramebuffer LATER("glBindFramebuffer", 30, "GL_ARB_framebuffer_object", (GLenum, GLuint))
#define glFogCoordf LATER("glFogCoordf", 14, 0, (GLfloat))
#define glFramebufferTexture2D \
    LATER("glFramebufferTexture2D", 30, "GL_ARB_framebuffer_object", (GLenum, GLenum, GLenum, GLuint, GLint))
#define glGenerateMipmap LATER("glGenerateMipmap", 30, "GL_ARB_framebuffer_object", (GLenum))
#define glMultiTexCoord2f LATER("glMultiTexCoord2f", 13, 0, (GLenum, GLfloat, GLfloat))
#define glPointParameterfv LATER("glPointParameterfv", 14, 0, (GLenum, const GLfloat*))
#define glPointParameteri LATER("glPointParameteri", 14, 0, (GLenum, GLint))
#define glSecondaryColor3f LATER("glSecondaryColor3f", 14, 0, (GLfloat, GLfloat, GLfloat))
#define glStencilFuncSeparate LATER("glStencilFuncSeparate", 20, 0, (GLenum, GLenum, GLint, GLuint))
#define glTexImage3D \
    LATER("glTexImage3D", 12, 0, (GLenum, GLint, GLint, GLsizei, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*))
#define glWindowPos2i LATER("glWindowPos2i", 14, 0, (GLint, GLint))

#endif
