//VTK::System::Dec
