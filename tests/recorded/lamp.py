# PyOpenGL; the warning is for the line of Python.
import os

from OpenGL.GL import *
from OpenGL.GLUT import *


def draw_lamp():
    glScalef(0.5, 0.5, 0.5)
    glutSolidSphere(1, 16, 12)  # warning: scale-without-normalize


def display():
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT)
    draw_lamp()
    glutSwapBuffers()
    glutLeaveMainLoop()


glutInit()
glutInitDisplayMode(GLUT_DOUBLE | GLUT_DEPTH)
glutInitWindowSize(64, 48)
glutCreateWindow(b"lamp")
glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_GLUTMAINLOOP_RETURNS)
glEnable(GL_DEPTH_TEST)
glEnable(GL_LIGHTING)
glEnable(GL_LIGHT0)
glutDisplayFunc(display)
glutMainLoop()
