"""Motions as glTF: a binary file of a drawing whose bodies, beams and surfaces move.

Source: Khronos Group, glTF 2.0 Specification (ISO/IEC 12113:2022).
"""
